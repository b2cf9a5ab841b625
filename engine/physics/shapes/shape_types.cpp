#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

using Corners = std::span<const Corner>;

AABB aroundCircle(const Geometry& geometry, Corners, const Frame& frame) {
    const Vec2 centre = apply(frame, geometry.a);
    return grown({centre, centre}, geometry.radius);
}

AABB aroundTwoPoints(const Geometry& geometry, Corners, const Frame& frame) {
    const Vec2 a = apply(frame, geometry.a);
    const Vec2 b = apply(frame, geometry.b);
    return grown({min(a, b), max(a, b)}, geometry.radius);
}

AABB aroundBox(const Geometry& geometry, Corners, const Frame& frame) {
    const Rot turn = frame.rotation * geometry.turn;
    const float c = std::fabs(turn.cos);
    const float s = std::fabs(turn.sin);
    const Vec2 centre = apply(frame, geometry.a);
    const Vec2 half{c * geometry.b.x + s * geometry.b.y, s * geometry.b.x + c * geometry.b.y};
    return grown({centre - half, centre + half}, geometry.radius);
}

AABB aroundPolygon(const Geometry& geometry, Corners pool, const Frame& frame) {
    const Corners corners = pool.subspan(geometry.first, geometry.count);
    const Vec2 start = rotate(frame.rotation, corners[0].point);
    AABB box{start, start};
    for (const Corner& corner : corners) {
        const Vec2 point = rotate(frame.rotation, corner.point);
        box = {min(box.min, point), max(box.max, point)};
    }
    return grown({frame.position + box.min, frame.position + box.max}, geometry.radius);
}

constexpr ShapeType kShapeTypes[] = {
    {"circle", true, aroundCircle},
    {"capsule", true, aroundTwoPoints},
    {"box", true, aroundBox},
    {"polygon", true, aroundPolygon},
    {"segment", false, aroundTwoPoints},
    {"chain segment", false, aroundTwoPoints},
};
static_assert(std::size(kShapeTypes) == static_cast<std::size_t>(ShapeKind::Count));

}  // namespace

const ShapeType& shapeTypeOf(ShapeKind kind) { return kShapeTypes[static_cast<std::size_t>(kind)]; }

AABB boundsOf(const Geometry& geometry, Corners corners, const Frame& frame) {
    return shapeTypeOf(geometry.kind).bounds(geometry, corners, frame);
}

float reachOf(const Geometry& geometry, Corners corners, Vec2 from) {
    const Convex convex = convexOf(geometry, corners);
    float square = 0.0f;
    for (const Corner& corner : convex.corners()) {
        const float far = lengthSquared(corner.point - from);
        square = far > square ? far : square;
    }
    return std::sqrt(square) + convex.radius;
}

float coreOf(const Geometry& geometry, Corners corners, Vec2 at) {
    const float depth = -closestPoint(geometry, corners, at).distance;
    return depth > 0.0f ? depth : 0.0f;
}

bool containsPoint(const Geometry& geometry, Corners corners, Vec2 point) {
    return shapeTypeOf(geometry.kind).solid && closestPoint(geometry, corners, point).distance <= 0.0f;
}

}  // namespace plumb::physics
