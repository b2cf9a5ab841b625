#include "physics/queries/shape_cast.hpp"

#include <algorithm>

#include "physics/narrowphase/sweep.hpp"
#include "physics/queries/candidates.hpp"
#include "physics/shapes.hpp"

namespace plumb::physics {

namespace {

/// An outline on its way, and the box around it.
struct Cast {
    const QueryShape& shape;
    Convex outline;
    Sweep sweep;
    AABB bounds;  // m, from the shape's position
};

std::span<const std::uint32_t> candidatesOf(World& world, const Cast& cast, const QueryFilter& filter) {
    const Vec2 half = 0.5f * cast.bounds.size();
    return candidatesAlong(world, cast.shape.position + cast.bounds.center(), cast.sweep.way, half, filter);
}

bool comesFromBehind(const World& world, std::uint32_t shape, const Cast& cast) {
    const Geometry& geometry = world.shapes.geometry[shape];
    if (geometry.kind != ShapeKind::ChainSegment) return false;
    const BodyPose& pose = world.bodies.pose[world.shapes.info[shape].body];
    const Vec2 normal = normalOfChain(geometry);
    const Vec2 centre =
        seenFrom(pose, cast.shape.position + rotate(cast.shape.rotation, cast.outline.centre));
    return dot(normal, centre - geometry.a) < 0.0f ||
           dot(normal, unrotate(pose.rotation, cast.sweep.way)) >= 0.0f;
}

std::optional<CastHit> hitOf(const World& world, std::uint32_t shape, const Cast& cast) {
    if (comesFromBehind(world, shape, cast)) return std::nullopt;
    const Sweep stays = resting(world.bodies.pose[world.shapes.info[shape].body]);
    const Convex theirs = convexOf(world.shapes.geometry[shape], world.shapes.corners);
    const auto impact = firstImpact({theirs, stays}, {cast.outline, cast.sweep}, 0.0f);
    if (!impact) return std::nullopt;
    CastHit hit;
    hit.shape = idOf(world, shape);
    hit.body = bodyOf(world, hit.shape);
    hit.point = impact->point;
    hit.normal = impact->normal;
    hit.fraction = impact->part;
    hit.distance = impact->part * length(cast.sweep.way);
    return hit;
}

Cast castOf(const World& world, const QueryShape& shape, Vec2 way) {
    Cast cast{shape, convexOf(shape.geometry, cornersOf(world, shape)), {}, boundsOf(world, shape)};
    cast.sweep.start = shape.position;
    cast.sweep.way = way;
    cast.sweep.rotation = shape.rotation;
    return cast;
}

}  // namespace

std::optional<CastHit> castShape(World& world, const QueryShape& shape, Vec2 way, const QueryFilter& filter) {
    if (!isUsable(world, shape) || !isUsable(way)) return std::nullopt;
    const Cast cast = castOf(world, shape, way);
    std::optional<CastHit> first;
    for (const std::uint32_t other : candidatesOf(world, cast, filter)) {
        const auto hit = hitOf(world, other, cast);
        if (hit && (!first || hit->fraction < first->fraction)) first = hit;
    }
    return first;
}

void castShapeAll(World& world, const QueryShape& shape, Vec2 way, const QueryFilter& filter,
                  std::vector<CastHit>& hits) {
    hits.clear();
    if (!isUsable(world, shape) || !isUsable(way)) return;
    const Cast cast = castOf(world, shape, way);
    for (const std::uint32_t other : candidatesOf(world, cast, filter)) {
        if (const auto hit = hitOf(world, other, cast)) hits.push_back(*hit);
    }
    std::sort(hits.begin(), hits.end(), [](const CastHit& a, const CastHit& b) {
        return a.fraction != b.fraction ? a.fraction < b.fraction : a.shape.index < b.shape.index;
    });
}

}  // namespace plumb::physics
