#include "physics/queries/ray_cast.hpp"

#include <algorithm>

#include "physics/model/shapes.hpp"
#include "physics/queries/candidates.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

std::span<const std::uint32_t> candidatesOf(World& world, WorldPosition from, Vec2 displacement,
                                            const QueryFilter& filter) {
    if (!isUsable(from) || !isUsable(displacement)) return {};
    return candidatesAlong(world, from, displacement, {}, filter);
}

std::optional<RayHit> hitOf(const World& world, std::uint32_t shape, WorldPosition from, Vec2 displacement) {
    const BodyPose& pose = poseOf(world, shape);
    return castRay(world.shapes.geometry[shape], world.shapes.corners,
                   Ray{seenFrom(pose, from), unrotate(pose.rotation, displacement)});
}

CastHit describe(const World& world, std::uint32_t shape, WorldPosition from, Vec2 displacement,
                 const RayHit& hit) {
    CastHit answer;
    answer.shape = idOf(world, shape);
    answer.body = bodyOf(world, answer.shape);
    answer.point = from + displacement * hit.fraction;
    answer.normal = rotate(poseOf(world, shape).rotation, hit.normal);
    answer.fraction = hit.fraction;
    answer.distance = hit.fraction * length(displacement);
    return answer;
}

}  // namespace

std::optional<CastHit> castRay(World& world, WorldPosition from, Vec2 displacement,
                               const QueryFilter& filter) {
    std::optional<RayHit> first;
    std::uint32_t firstShape = kNone;
    for (const std::uint32_t shape : candidatesOf(world, from, displacement, filter)) {
        const std::optional<RayHit> hit = hitOf(world, shape, from, displacement);
        if (!hit || (first && hit->fraction >= first->fraction)) continue;
        first = hit;
        firstShape = shape;
    }
    if (!first) return std::nullopt;
    return describe(world, firstShape, from, displacement, *first);
}

bool isRayBlocked(World& world, WorldPosition from, Vec2 displacement, const QueryFilter& filter) {
    const std::span<const std::uint32_t> candidates = candidatesOf(world, from, displacement, filter);
    return std::any_of(candidates.begin(), candidates.end(), [&](std::uint32_t shape) {
        return hitOf(world, shape, from, displacement).has_value();
    });
}

void castRayAll(World& world, WorldPosition from, Vec2 displacement, const QueryFilter& filter,
                std::vector<CastHit>& hits) {
    hits.clear();
    for (const std::uint32_t shape : candidatesOf(world, from, displacement, filter)) {
        if (const auto hit = hitOf(world, shape, from, displacement))
            hits.push_back(describe(world, shape, from, displacement, *hit));
    }
    sortByFraction(hits);
}

}  // namespace plumb::physics
