#include <array>

#include "physics/debug/picture.hpp"

namespace plumb::physics {

namespace {

constexpr int kArcHalvings = 3;
constexpr int kArcPoints = 1 << kArcHalvings;

/// Directions between two outward normals, in the order of the corners.
void fillArc(Vec2* directions, Vec2 from, Vec2 to, int halvings) {
    if (halvings == 0) {
        *directions = from;
        return;
    }
    // At the ends of a capsule the normals are opposite, and their sum is zero.
    const Vec2 side{to.y - from.y, from.x - to.x};
    const Vec2 middle = normalized(dot(from, to) < 0.0f ? side : from + to);
    fillArc(directions, from, middle, halvings - 1);
    fillArc(directions + (1 << (halvings - 1)), middle, to, halvings - 1);
}

/// The faces, offset by the radius, with arcs between them.
void drawRounded(DebugCanvas& canvas, std::span<const Corner> corners, const Frame& frame, float radius,
                 DebugInk ink) {
    std::array<Vec2, kMaxCorners*(kArcPoints + 1)> points;
    std::size_t count = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 before = corners[i > 0 ? i - 1 : corners.size() - 1].normal;
        std::array<Vec2, kArcPoints + 1> arc;
        fillArc(arc.data(), before, corners[i].normal, kArcHalvings);
        arc.back() = corners[i].normal;
        for (const Vec2 out : arc) points[count++] = apply(frame, corners[i].point + radius * out);
    }
    canvas.polygon({points.data(), count}, ink);
}

/// With a spoke that shows its rotation.
void drawDisc(DebugCanvas& canvas, Vec2 centre, const Frame& frame, float radius, DebugInk ink) {
    const Vec2 place = apply(frame, centre);
    canvas.circle(place, radius, ink);
    canvas.line(place, place + rotate(frame.rotation, {radius, 0.0f}), ink);
}

}  // namespace

void drawOutline(DebugCanvas& canvas, const Convex& convex, const Frame& frame, DebugInk ink) {
    const std::span<const Corner> corners = convex.corners();
    if (corners.size() == 1) return drawDisc(canvas, corners[0].point, frame, convex.radius, ink);
    if (convex.radius > 0.0f) return drawRounded(canvas, corners, frame, convex.radius, ink);
    if (corners.size() == 2)
        return canvas.line(apply(frame, corners[0].point), apply(frame, corners[1].point), ink);
    std::array<Vec2, kMaxCorners> points;
    for (std::size_t i = 0; i < corners.size(); ++i) points[i] = apply(frame, corners[i].point);
    canvas.polygon({points.data(), corners.size()}, ink);
}

void DebugCanvas::box(const AABB& box, DebugInk ink) {
    const std::array<Vec2, 4> corners{box.min, Vec2{box.max.x, box.min.y}, box.max,
                                      Vec2{box.min.x, box.max.y}};
    polygon(corners, ink);
}

void drawArc(DebugCanvas& canvas, Vec2 centre, float radius, Rot from, float angle, DebugInk ink) {
    constexpr int kLines = 2 * kArcPoints;
    const Rot turn = rotFromAngle(angle / static_cast<float>(kLines));
    for (int i = 0; i < kLines; ++i) {
        const Rot to = normalized(turn * from);
        canvas.line(centre + radius * Vec2{from.cos, from.sin}, centre + radius * Vec2{to.cos, to.sin}, ink);
        from = to;
    }
}

}  // namespace plumb::physics
