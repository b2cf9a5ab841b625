#include "physics/queries/shape_cast.hpp"

#include "physics/model/shapes.hpp"
#include "physics/narrowphase/shape_cast.hpp"
#include "physics/queries/candidates.hpp"

namespace plumb::physics {

namespace {

std::span<const std::uint32_t> candidatesOf(World& world, const QueryShape& shape, Vec2 displacement,
                                            const QueryFilter& filter) {
    const AABB bounds = boundsOf(world, shape);
    return candidatesAlong(world, shape.position + bounds.center(), displacement, 0.5f * bounds.size(),
                           filter);
}

MovingOutline outlineOf(const World& world, const QueryShape& shape, Vec2 displacement) {
    return {convexOf(shape.geometry, cornersOf(world, shape)), shape.position, shape.rotation, displacement};
}

}  // namespace

std::optional<CastHit> meet(const World& world, std::uint32_t shape, const BodyPose& pose,
                            const MovingOutline& moving) {
    const Geometry& geometry = world.shapes.geometry[shape];
    const bool isChain = geometry.kind == ShapeKind::ChainSegment;
    const Frame frame = seenFrom(pose, moving.position, moving.rotation);
    const Vec2 displacement = unrotate(pose.rotation, moving.displacement);
    const Vec2 front = isChain ? normalOfChain(geometry) : Vec2{};
    if (isChain) {
        const float height = dot(front, apply(frame, moving.outline.centre) - geometry.a);
        if (height < 0.0f || dot(front, displacement) >= 0.0f) return std::nullopt;
    }
    const Convex theirs = convexOf(geometry, world.shapes.corners);
    const auto met = castShape(theirs, moving.outline, frame, displacement);
    if (!met) return std::nullopt;
    CastHit hit;
    hit.shape = idOf(world, shape);
    hit.body = bodyOf(world, hit.shape);
    hit.point = placeOf(pose, met->point);
    // The direction of minimum penetration of a chain segment may point to its back.
    hit.normal = rotate(pose.rotation, isChain && met->separation < 0.0f ? front : met->normal);
    hit.fraction = met->fraction;
    hit.distance = met->fraction * length(moving.displacement);
    hit.separation = met->separation;
    return hit;
}

std::optional<CastHit> castShape(World& world, const QueryShape& shape, Vec2 displacement,
                                 const QueryFilter& filter) {
    if (!isUsable(world, shape) || !isUsable(displacement)) return std::nullopt;
    const MovingOutline moving = outlineOf(world, shape, displacement);
    std::optional<CastHit> first;
    for (const std::uint32_t other : candidatesOf(world, shape, displacement, filter)) {
        const auto hit = meet(world, other, poseOf(world, other), moving);
        if (hit && (!first || hit->fraction < first->fraction)) first = hit;
    }
    return first;
}

void castShapeAll(World& world, const QueryShape& shape, Vec2 displacement, const QueryFilter& filter,
                  std::vector<CastHit>& hits) {
    hits.clear();
    if (!isUsable(world, shape) || !isUsable(displacement)) return;
    const MovingOutline moving = outlineOf(world, shape, displacement);
    for (const std::uint32_t other : candidatesOf(world, shape, displacement, filter)) {
        if (const auto hit = meet(world, other, poseOf(world, other), moving)) hits.push_back(*hit);
    }
    sortByFraction(hits);
}

}  // namespace plumb::physics
