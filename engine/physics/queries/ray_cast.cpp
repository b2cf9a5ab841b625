#include "physics/queries/ray_cast.hpp"

#include <algorithm>

#include "physics/queries/candidates.hpp"
#include "physics/shapes.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

std::span<const std::uint32_t> candidatesOf(World& world, Place from, Vec2 way, const QueryFilter& filter) {
    if (!isUsable(from) || !isUsable(way)) return {};
    return candidatesAlong(world, from, way, {}, filter);
}

std::optional<RayHit> hitOf(const World& world, std::uint32_t shape, Place from, Vec2 way) {
    const BodyPose& pose = poseOf(world, shape);
    return castRay(world.shapes.geometry[shape], world.shapes.corners,
                   Ray{seenFrom(pose, from), unrotate(pose.rotation, way)});
}

CastHit describe(const World& world, std::uint32_t shape, Place from, Vec2 way, const RayHit& hit) {
    CastHit answer;
    answer.shape = idOf(world, shape);
    answer.body = bodyOf(world, answer.shape);
    answer.point = from + way * hit.fraction;
    answer.normal = rotate(poseOf(world, shape).rotation, hit.normal);
    answer.fraction = hit.fraction;
    answer.distance = hit.fraction * length(way);
    return answer;
}

}  // namespace

std::optional<CastHit> castRay(World& world, Place from, Vec2 way, const QueryFilter& filter) {
    std::optional<RayHit> first;
    std::uint32_t firstShape = kNone;
    for (const std::uint32_t shape : candidatesOf(world, from, way, filter)) {
        const std::optional<RayHit> hit = hitOf(world, shape, from, way);
        if (!hit || (first && hit->fraction >= first->fraction)) continue;
        first = hit;
        firstShape = shape;
    }
    if (!first) return std::nullopt;
    return describe(world, firstShape, from, way, *first);
}

bool isRayBlocked(World& world, Place from, Vec2 way, const QueryFilter& filter) {
    const std::span<const std::uint32_t> candidates = candidatesOf(world, from, way, filter);
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](std::uint32_t shape) { return hitOf(world, shape, from, way).has_value(); });
}

void castRayAll(World& world, Place from, Vec2 way, const QueryFilter& filter, std::vector<CastHit>& hits) {
    hits.clear();
    for (const std::uint32_t shape : candidatesOf(world, from, way, filter)) {
        if (const auto hit = hitOf(world, shape, from, way))
            hits.push_back(describe(world, shape, from, way, *hit));
    }
    sortByFraction(hits);
}

}  // namespace plumb::physics
