#include "box_physics/narrowphase/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumb::box_physics {

namespace {

/// One side that could keep two outlines apart: their distance along its normal, and how it changes.
struct Plane {
    Vec2 normal;
    float distance;  // m at the start
    float change;    // m over the path
    bool face;       // a face of the other outline, not a side of the mover
    bool inner;      // lies against a neighbour
};

template <int Most>
struct PlaneList {
    std::array<Plane, Most> items;
    int count = 0;

    void add(Vec2 normal, float distance, float change, bool face, bool inner) {
        items[static_cast<std::size_t>(count++)] = {normal, distance, change, face, inner};
    }
};

bool isAxis(Vec2 normal) { return normal.x == 0.0f || normal.y == 0.0f; }

/// True when the outlines share only a corner's breadth: the seam of two floors, not a wall.
template <int Most>
bool onlyGrazes(const PlaneList<Most>& planes, const Plane& chosen, float time, float breadth) {
    if (!isAxis(chosen.normal)) return false;
    for (int i = 0; i < planes.count; ++i) {
        const Plane& plane = planes.items[static_cast<std::size_t>(i)];
        if (!isAxis(plane.normal) || dot(plane.normal, chosen.normal) != 0.0f) continue;
        if (plane.distance + plane.change * time >= -breadth) return true;
    }
    return false;
}

/// When all planes are crossed the outlines overlap: the last one crossed is the one that was hit.
template <int Most>
Touch firstTouch(const PlaneList<Most>& planes, float slack, const Settings& settings) {
    const float breadth = settings.seamDistance + slack;
    const float margin = settings.touchDistance;
    float enter = -std::numeric_limits<float>::infinity();
    float leave = std::numeric_limits<float>::infinity();
    for (int i = 0; i < planes.count; ++i) {
        const Plane& plane = planes.items[static_cast<std::size_t>(i)];
        const float gap = plane.distance - margin;
        if (gap > 0.0f && plane.change >= 0.0f) return {};
        if (plane.change < 0.0f) enter = std::max(enter, gap / -plane.change);
        if (plane.change > 0.0f) leave = std::min(leave, -gap / plane.change);
    }
    if (enter > 1.0f || enter > leave || leave < 0.0f) return {};
    const float time = std::max(enter, 0.0f);
    const Plane* chosen = nullptr;
    float best = -std::numeric_limits<float>::infinity();
    for (int i = 0; i < planes.count; ++i) {
        const Plane& plane = planes.items[static_cast<std::size_t>(i)];
        if (plane.inner && time == 0.0f) continue;
        // Where a face and a side meet in one corner, the face knows better which way is out.
        const float value = plane.distance + plane.change * time + (plane.face ? breadth : 0.0f);
        if (value > best) best = value, chosen = &plane;
    }
    if (chosen == nullptr || chosen->inner) return {};
    if (onlyGrazes(planes, *chosen, time, breadth)) return {};
    return {true, TouchRank::Face, time, chosen->distance, chosen->normal};
}

float reach(Vec2 half, Vec2 normal) { return half.x * std::abs(normal.x) + half.y * std::abs(normal.y); }

constexpr Vec2 kSides[4] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};

Touch boxToConvex(const Mover& mover, const Convex& convex, const Settings& settings) {
    PlaneList<Convex::kMaxPoints + 4> planes;
    unsigned sidesSeen = 0;
    for (int i = 0; i < convex.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Vec2 n = convex.normals[at];
        const float distance = dot(n, mover.centre - convex.points[at]) - reach(mover.half, n);
        planes.add(n, distance, dot(n, mover.path), true, convex.isInner(i));
        for (unsigned side = 0; side < 4; ++side) {
            if (n == kSides[side]) sidesSeen |= 1u << side;
        }
    }
    for (unsigned side = 0; side < 4; ++side) {
        if ((sidesSeen >> side & 1u) != 0) continue;
        const Vec2 n = kSides[side];
        float furthest = -std::numeric_limits<float>::infinity();
        for (int i = 0; i < convex.count; ++i) {
            furthest = std::max(furthest, dot(n, convex.points[static_cast<std::size_t>(i)]));
        }
        const float distance = dot(n, mover.centre) - furthest - reach(mover.half, n);
        planes.add(n, distance, dot(n, mover.path), false, false);
    }
    return firstTouch(planes, mover.slack, settings);
}

/// The moving point `from` + path against a circle of this radius at the origin.
Touch pointToDisc(Vec2 from, Vec2 path, float radius, float margin) {
    const float reachSquared = (radius + margin) * (radius + margin);
    const float c = lengthSquared(from) - reachSquared;
    const Vec2 away = normalized(from);
    const Vec2 out = away == Vec2{} ? Vec2{0, -1} : away;
    if (c <= 0.0f) return {true, TouchRank::Corner, 0.0f, length(from) - radius, out};
    const float a = lengthSquared(path);
    const float b = dot(from, path);
    if (b >= 0.0f || a == 0.0f) return {};
    const float root = b * b - a * c;
    if (root < 0.0f) return {};
    const float time = c / (-b + std::sqrt(root));  // the form that does not cancel
    if (time > 1.0f) return {};
    const Vec2 normal = normalized(from + path * time);
    return {true, TouchRank::Corner, time, std::max(dot(normal, from) - radius, 0.0f), normal};
}

/// A circle's centre against one face: only where the face itself is nearest, not its corners.
Touch pointToFace(const Mover& mover, const Convex& convex, int face, float margin) {
    const auto at = static_cast<std::size_t>(face);
    const Vec2 a = convex.points[at];
    const Vec2 edge = convex.points[static_cast<std::size_t>(convex.next(face))] - a;
    const Vec2 n = convex.normals[at];
    const float distance = dot(n, mover.centre - a) - mover.half.x;
    const float change = dot(n, mover.path);
    const float gap = distance - margin;
    float time = 0.0f;
    if (gap > 0.0f) {
        if (change >= 0.0f || gap > -change) return {};
        time = gap / -change;
    }
    const float along = dot(mover.centre + mover.path * time - a, edge);
    if (along < 0.0f || along > lengthSquared(edge)) return {};
    return {true, TouchRank::Face, time, distance, n};
}

/// The face through which a centre inside the outline is pushed out.
Touch fromInside(const Mover& mover, const Convex& convex, bool& inside) {
    Touch best;
    best.separation = -std::numeric_limits<float>::infinity();
    inside = true;
    for (int i = 0; i < convex.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const float distance = dot(convex.normals[at], mover.centre - convex.points[at]);
        if (distance > 0.0f) inside = false;
        if (convex.isInner(i) || distance - mover.half.x <= best.separation) continue;
        best = {true, TouchRank::Face, 0.0f, distance - mover.half.x, convex.normals[at]};
    }
    return best;
}

bool isBetter(const Touch& a, const Touch& b) {
    if (!b.hit || !a.hit) return a.hit;
    if (a.rank == TouchRank::InnerCorner || b.rank == TouchRank::InnerCorner) {
        if (a.rank != b.rank) return a.rank < b.rank;
    }
    if (a.time != b.time) return a.time < b.time;
    return a.separation < b.separation;
}

Touch circleToConvex(const Mover& mover, const Convex& convex, const Settings& settings) {
    bool inside = false;
    const Touch deep = fromInside(mover, convex, inside);
    if (inside) return deep;
    Touch best;
    for (int i = 0; i < convex.count; ++i) {
        const int before = i == 0 ? convex.count - 1 : i - 1;
        if (!convex.isInner(i)) {
            const Touch touch = pointToFace(mover, convex, i, settings.touchDistance);
            // A face seen from behind is not the nearest part; its corners or the other faces are.
            if (touch.separation > -mover.half.x && isBetter(touch, best)) best = touch;
        }
        const Vec2 from = mover.centre - convex.points[static_cast<std::size_t>(i)];
        Touch corner = pointToDisc(from, mover.path, mover.half.x, settings.touchDistance);
        if (convex.isInner(i) || convex.isInner(before)) corner.rank = TouchRank::InnerCorner;
        if (isBetter(corner, best)) best = corner;
    }
    return best;
}

}  // namespace

Touch sweepToBox(const Mover& mover, Vec2 centre, Vec2 half, const Settings& settings) {
    if (mover.kind == ShapeKind::Circle) {
        const Vec2 points[4] = {{centre.x - half.x, centre.y - half.y},
                                {centre.x + half.x, centre.y - half.y},
                                {centre.x + half.x, centre.y + half.y},
                                {centre.x - half.x, centre.y + half.y}};
        return circleToConvex(mover, convexFrom(points, 4), settings);
    }
    PlaneList<4> planes;
    const Vec2 from = mover.centre - centre;
    const Vec2 sum = mover.half + half;
    planes.add({0, -1}, -from.y - sum.y, -mover.path.y, true, false);
    planes.add({1, 0}, from.x - sum.x, mover.path.x, true, false);
    planes.add({0, 1}, from.y - sum.y, mover.path.y, true, false);
    planes.add({-1, 0}, -from.x - sum.x, -mover.path.x, true, false);
    return firstTouch(planes, mover.slack, settings);
}

Touch sweepToCircle(const Mover& mover, Vec2 centre, float radius, const Settings& settings) {
    if (mover.kind == ShapeKind::Circle) {
        return pointToDisc(mover.centre - centre, mover.path, mover.half.x + radius, settings.touchDistance);
    }
    const Mover reversed{ShapeKind::Circle, centre, {radius, radius}, -mover.path, mover.slack};
    Touch touch = sweepToBox(reversed, mover.centre, mover.half, settings);
    touch.normal = -touch.normal;
    return touch;
}

Touch sweepToConvex(const Mover& mover, const Convex& convex, const Settings& settings) {
    return mover.kind == ShapeKind::Circle ? circleToConvex(mover, convex, settings)
                                           : boxToConvex(mover, convex, settings);
}

Vec2 touchPoint(const Mover& mover, const Touch& touch) {
    const Vec2 centre = mover.centre + mover.path * touch.time;
    if (mover.kind == ShapeKind::Circle) return centre - touch.normal * mover.half.x;
    const auto side = [](float n, float half) { return n > 0.0f ? -half : n < 0.0f ? half : 0.0f; };
    return centre + Vec2{side(touch.normal.x, mover.half.x), side(touch.normal.y, mover.half.y)};
}

}  // namespace plumb::box_physics
