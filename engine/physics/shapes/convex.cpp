#include "physics/shapes/convex.hpp"

#include "physics/tuning.hpp"

namespace plumb::physics {

std::array<Corner, 4> cornersOfBox(Vec2 centre, Vec2 half, Rot rotation) {
    const Vec2 x = rotate(rotation, {1.0f, 0.0f});
    const Vec2 y = rotate(rotation, {0.0f, 1.0f});
    const Vec2 along = x * half.x;
    const Vec2 across = y * half.y;
    return {Corner{centre - along - across, -y}, Corner{centre + along - across, x},
            Corner{centre + along + across, y}, Corner{centre - along + across, -x}};
}

int farthest(std::span<const Corner> corners, Vec2 direction) {
    const auto reachOf = [&](const Corner& corner) { return dot(corner.point, direction); };
    return static_cast<int>(largestOf(corners, reachOf).index);
}

float reachAlong(const Convex& outline, Vec2 direction) {
    const auto reachOf = [&](const Corner& corner) { return dot(corner.point, direction); };
    return largestOf(outline.corners(), reachOf).value + outline.radius;
}

ScaledConvex::ScaledConvex(const Convex& outline, Vec2 about, float part) : convex_{outline} {
    const auto scaled = [&](Vec2 point) { return about + part * (point - about); };
    std::size_t count = 0;
    for (const Corner& corner : outline.corners())
        room_.corners[count++] = {scaled(corner.point), corner.normal};
    convex_.pool = room_.corners;
    convex_.centre = scaled(outline.centre);
    convex_.radius *= part;
}

Convex convexOf(const Geometry& geometry, std::span<const Corner> pool) {
    Convex convex{.radius = geometry.radius, .centre = geometry.a};
    const auto takeDisc = [&] {
        convex.own[0] = {convex.centre, kAnyNormal};
        convex.count = 1;
    };
    const auto takeSegment = [&] {
        const Vec2 along = normalized(geometry.b - geometry.a);
        convex.own[0] = {geometry.a, {along.y, -along.x}};
        convex.own[1] = {geometry.b, {-along.y, along.x}};
        convex.count = 2;
        convex.centre = (geometry.a + geometry.b) * 0.5f;
    };
    switch (geometry.kind) {
        case ShapeKind::Circle: takeDisc(); break;
        case ShapeKind::Capsule:
            takeSegment();
            if (!(distance(geometry.a, geometry.b) > kBlur * geometry.radius)) takeDisc();
            break;
        case ShapeKind::Box:
            convex.own = cornersOfBox(geometry.a, geometry.b, geometry.rotation);
            convex.count = 4;
            break;
        case ShapeKind::Polygon:
            convex.pool = pool.data() + geometry.first;
            convex.count = geometry.count;
            break;
        case ShapeKind::Segment:
        case ShapeKind::ChainSegment:
        case ShapeKind::Count:
            takeSegment();
            convex.radius = 0.0f;
            break;
    }
    return convex;
}

}  // namespace plumb::physics
