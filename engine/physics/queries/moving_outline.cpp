#include "physics/queries/moving_outline.hpp"

#include "physics/model/shapes.hpp"
#include "physics/narrowphase/shape_cast.hpp"
#include "physics/queries/candidates.hpp"

namespace plumb::physics {

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

}  // namespace plumb::physics
