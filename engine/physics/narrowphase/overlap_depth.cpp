#include "physics/narrowphase/minkowski.hpp"

namespace plumb::physics {

namespace {

/// The set of ways has at most as many corners as both outlines together.
constexpr int kMostWays = 2 * kMaxCorners + 4;
/// Ratio to the size of the set: what a new corner must stand out by.
constexpr float kFlat = 1.0e-6f;

/// A polygon of ways, in the sense in which normals turn, that grows towards the true one.
struct Polytope {
    Way ways[kMostWays];
    int count = 0;
    float size = 0.0f;  ///< m: of the ways

    bool contains(const Way& way) const {
        for (int i = 0; i < count; ++i) {
            if (ways[i] == way) return true;
        }
        return false;
    }
    void insert(int place, const Way& way) {
        for (int i = count; i > place; --i) ways[i] = ways[i - 1];
        ways[place] = way;
        ++count;
        size = std::max(size, std::max(std::fabs(way.way.x), std::fabs(way.way.y)));
    }
};

/// The extreme ways along both axes: a polygon, or the two ends where all ways are on one line. It need not
/// be around the way that leads nowhere; then that is outside of the side that grows first.
Polytope startFrom(const Ways& set) {
    Polytope polytope;
    for (const Vec2 direction : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
        const Way way = set.farthestAlong(direction);
        bool known = false;
        for (int i = 0; i < polytope.count; ++i) {
            known = known || distance(polytope.ways[i].way, way.way) <= kFlat * polytope.size;
        }
        if (!known) polytope.insert(polytope.count, way);
    }
    return polytope;
}

/// The side nearest to the way that leads nowhere.
struct NearestSide {
    int index = 0;
    Vec2 normal = kAnyNormal;
    float distance = 1.0e30f;
};

NearestSide nearestSide(const Polytope& polytope) {
    NearestSide nearest;
    for (int i = 0; i < polytope.count; ++i) {
        const Vec2 start = polytope.ways[i].way;
        const Vec2 side = polytope.ways[i + 1 < polytope.count ? i + 1 : 0].way - start;
        const Vec2 normal = normalized(Vec2{side.y, -side.x});
        const float distance = dot(normal, start);
        if (normal == Vec2{} || !(distance < nearest.distance)) continue;
        nearest = {i, normal, distance};
    }
    return nearest;
}

}  // namespace

WayBetween deepestOverlap(const Ways& ways) {
    Polytope polytope = startFrom(ways);
    WayBetween result{polytope.ways[0], polytope.ways[0], 0.0f, kAnyNormal, 0.0f, 0};
    if (polytope.count < 2) return result;  // two discs on one centre
    NearestSide side = nearestSide(polytope);
    while (polytope.count < kMostWays) {
        ++result.iterations;
        const Way way = ways.farthestAlong(side.normal);
        const float out = dot(way.way, side.normal) - side.distance;
        if (!(out > kFlat * polytope.size) || polytope.contains(way)) break;
        polytope.insert(side.index + 1, way);
        side = nearestSide(polytope);
    }
    result.first = polytope.ways[side.index];
    result.second = polytope.ways[side.index + 1 < polytope.count ? side.index + 1 : 0];
    // Ways are from A to B: the way that leads nowhere is inside the set by this, and B has to go the other
    // way.
    result.normal = -side.normal;
    result.distance = -side.distance;
    const Vec2 edge = result.second.way - result.first.way;
    const float square = lengthSquared(edge);
    result.part = square > 0.0f ? -dot(result.first.way, edge) / square : 0.0f;
    result.part = result.part < 0.0f ? 0.0f : result.part > 1.0f ? 1.0f : result.part;
    return result;
}

}  // namespace plumb::physics
