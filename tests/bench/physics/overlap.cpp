#include "tests/bench/physics/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb::scenes {

namespace {

constexpr double kFar = std::numeric_limits<double>::max();

Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double length(Point a) { return std::sqrt(dot(a, a)); }

/// Returns the gap along a direction from the end of `from` to the start of `to`; negative if they overlap.
double gapAlong(Point direction, const PlacedOutline& from, const PlacedOutline& to) {
    double end = -kFar;
    double begin = kFar;
    for (const Point point : from.corners()) end = std::max(end, dot(direction, point));
    for (const Point point : to.corners()) begin = std::min(begin, dot(direction, point));
    return begin - end;
}

/// Returns the maximum gap along the normals of a's edges, and for a line also along its direction.
double widestGap(const PlacedOutline& a, const PlacedOutline& b) {
    double widest = -kFar;
    for (std::size_t i = 0; i < a.count && a.count > 1; ++i) {
        const Point edge = a.points[(i + 1) % a.count] - a.points[i];
        const double size = length(edge);
        if (size <= 0.0) continue;
        const Point normal{edge.y / size, -edge.x / size};
        widest = std::max(widest, gapAlong(normal, a, b));
        if (a.count == 2) widest = std::max(widest, gapAlong({-normal.y, normal.x}, a, b));
    }
    return widest;
}

double distanceToEdge(Point point, Point start, Point end) {
    const Point edge = end - start;
    const double square = dot(edge, edge);
    const double share = square > 0.0 ? std::clamp(dot(point - start, edge) / square, 0.0, 1.0) : 0.0;
    return length(point - Point{start.x + share * edge.x, start.y + share * edge.y});
}

/// Returns the minimum distance from the corners of `a` to the edges of `b`.
double cornerDistance(const PlacedOutline& a, const PlacedOutline& b) {
    double nearest = kFar;
    for (const Point corner : a.corners()) {
        for (std::size_t i = 0; i < b.count; ++i)
            nearest = std::min(nearest, distanceToEdge(corner, b.points[i], b.points[(i + 1u) % b.count]));
    }
    return nearest;
}

/// Returns the maximum depth of the corners of `body` on the solid (left) side of a one-sided line.
double depthBehind(const PlacedOutline& line, const PlacedOutline& body) {
    const Point edge = line.points[1] - line.points[0];
    const double size = length(edge);
    const Point right{edge.y / size, -edge.x / size};
    double deepest = 0.0;
    for (const Point corner : body.corners()) {
        const Point arm = corner - line.points[0];
        const double along = dot(arm, edge) / size;
        if (along >= 0.0 && along <= size) deepest = std::max(deepest, body.radius - dot(arm, right));
    }
    return deepest;
}

}  // namespace

PlacedOutline place(const Outline& outline, const Pose& pose) {
    PlacedOutline placed;
    placed.count = outline.count;
    placed.radius = static_cast<double>(outline.radius);
    placed.oneSided = outline.kind == OutlineKind::ChainSegment;
    placed.low = {kFar, kFar};
    placed.high = {-kFar, -kFar};
    for (std::size_t i = 0; i < outline.count; ++i) {
        const auto x = static_cast<double>(outline.points[i].x);
        const auto y = static_cast<double>(outline.points[i].y);
        const Point point{pose.x + pose.cos * x - pose.sin * y, pose.y + pose.sin * x + pose.cos * y};
        placed.points[i] = point;
        placed.low = {std::min(placed.low.x, point.x), std::min(placed.low.y, point.y)};
        placed.high = {std::max(placed.high.x, point.x), std::max(placed.high.y, point.y)};
    }
    placed.low = placed.low - Point{placed.radius, placed.radius};
    placed.high = placed.high - Point{-placed.radius, -placed.radius};
    return placed;
}

double overlapOf(const PlacedOutline& a, const PlacedOutline& b) {
    const double reach = a.radius + b.radius;
    double gap = std::max(widestGap(a, b), widestGap(b, a));
    if (gap > reach) return 0.0;
    // If the outlines without radius are separated, or both are points, the depth follows from their
    // distance.
    if (gap > 0.0 || gap == -kFar) gap = std::min(cornerDistance(a, b), cornerDistance(b, a));
    if (gap > reach) return 0.0;
    if (a.oneSided) return depthBehind(a, b);
    if (b.oneSided) return depthBehind(b, a);
    return reach - gap;
}

}  // namespace plumb::scenes
