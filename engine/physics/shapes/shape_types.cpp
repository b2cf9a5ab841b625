#include "physics/shapes/shape_types.hpp"

#include "physics/shapes/check.hpp"

namespace plumb::physics {

namespace {

using Corners = std::span<const Corner>;

AABB aroundDisc(Vec2 centre, float radius) { return grown({centre, centre}, radius); }

AABB aroundCircle(const Geometry& geometry, Corners, const Frame& frame) {
    return aroundDisc(apply(frame, geometry.a), geometry.radius);
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

std::optional<RayHit> castAtConvex(const Geometry& geometry, Corners corners, const Ray& ray) {
    return castRayAt(convexOf(geometry, corners), ray);
}

std::optional<RayHit> castAtChain(const Geometry& geometry, Corners corners, const Ray& ray) {
    if (!(dot(ray.displacement, normalOfChain(geometry)) < 0.0f)) return std::nullopt;
    return castAtConvex(geometry, corners, ray);
}

constexpr ShapeType kShapeTypes[] = {
    {"circle", true, aroundCircle, castAtConvex, checkCircle},
    {"capsule", true, aroundTwoPoints, castAtConvex, checkCapsule},
    {"box", true, aroundBox, castAtConvex, checkBox},
    {"polygon", true, aroundPolygon, castAtConvex, checkPolygon},
    {"segment", false, aroundTwoPoints, castAtConvex, checkSegment},
    {"chain segment", false, aroundTwoPoints, castAtChain, checkSegment},
};
static_assert(std::size(kShapeTypes) == static_cast<std::size_t>(ShapeKind::Count));

}  // namespace

const ShapeType& shapeTypeOf(ShapeKind kind) { return kShapeTypes[static_cast<std::size_t>(kind)]; }

Result<Done> checkGeometry(const Geometry& geometry, Corners corners) {
    if (geometry.kind >= ShapeKind::Count)
        return Error{"shape.kind", "expected a kind of shape, found another number", "use a ShapeKind"};
    return shapeTypeOf(geometry.kind).check(geometry, corners);
}

MassProperties massProperties(const Geometry& geometry, Corners corners, float density) {
    return massOf(convexOf(geometry, corners), density);
}

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

ClosestPoint closestPoint(const Geometry& geometry, Corners corners, Vec2 place) {
    return closestPointOf(convexOf(geometry, corners), place);
}

std::optional<RayHit> castRay(const Geometry& geometry, Corners corners, const Ray& ray) {
    return shapeTypeOf(geometry.kind).castRay(geometry, corners, ray);
}

}  // namespace plumb::physics
