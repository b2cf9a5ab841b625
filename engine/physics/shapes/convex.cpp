#include "physics/shapes/convex.hpp"

#include <algorithm>

#include "physics/tuning.hpp"

namespace plumb::physics {

std::array<Corner, 4> cornersOfBox(Vec2 centre, Vec2 half, Rot turn) {
    const Vec2 x = rotate(turn, {1.0f, 0.0f});
    const Vec2 y = rotate(turn, {0.0f, 1.0f});
    const Vec2 along = x * half.x;
    const Vec2 across = y * half.y;
    return {Corner{centre - along - across, -y}, Corner{centre + along - across, x},
            Corner{centre + along + across, y}, Corner{centre - along + across, -x}};
}

int farthest(std::span<const Corner> corners, Vec2 direction) {
    int best = 0;
    float maximum = dot(corners[0].point, direction);
    for (int i = 1; i < static_cast<int>(corners.size()); ++i) {
        const float reach = dot(corners[static_cast<std::size_t>(i)].point, direction);
        if (reach > maximum) {
            maximum = reach;
            best = i;
        }
    }
    return best;
}

float reachAlong(const Convex& outline, Vec2 direction) {
    const auto corner = static_cast<std::size_t>(farthest(outline.corners(), direction));
    return dot(outline.corners()[corner].point, direction) + outline.radius;
}

ScaledConvex::ScaledConvex(const Convex& outline, Vec2 about, float part) : convex_{outline} {
    const auto scaled = [&](Vec2 point) { return about + part * (point - about); };
    std::transform(outline.corners().begin(), outline.corners().end(), room_.corners,
                   [&](const Corner& corner) {
                       return Corner{scaled(corner.point), corner.normal};
                   });
    convex_.pool = room_.corners;
    convex_.centre = scaled(outline.centre);
    convex_.radius *= part;
}

Convex convexOf(const Geometry& geometry, std::span<const Corner> pool) {
    Convex convex{.radius = geometry.radius, .centre = geometry.a};
    const auto takeSegment = [&] {
        const Vec2 along = normalized(geometry.b - geometry.a);
        convex.own[0] = {geometry.a, {along.y, -along.x}};
        convex.own[1] = {geometry.b, {-along.y, along.x}};
        convex.count = 2;
        convex.centre = (geometry.a + geometry.b) * 0.5f;
    };
    switch (geometry.kind) {
        case ShapeKind::Circle:
            convex.own[0] = {geometry.a, kAnyNormal};
            convex.count = 1;
            break;
        case ShapeKind::Capsule:
            takeSegment();
            if (!(distance(geometry.a, geometry.b) > kBlur * geometry.radius)) {
                convex.own[0] = {convex.centre, kAnyNormal};
                convex.count = 1;
            }
            break;
        case ShapeKind::Box:
            convex.own = cornersOfBox(geometry.a, geometry.b, geometry.turn);
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
