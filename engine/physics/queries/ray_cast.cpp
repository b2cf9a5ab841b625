#include "physics/queries/ray_cast.hpp"

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

std::optional<CastHit> hitOf(const World& world, std::uint32_t shape, WorldPosition from, Vec2 displacement) {
    const BodyPose& pose = poseOf(world, shape);
    const std::optional<RayHit> hit =
        castRay(world.shapes.geometry[shape], world.shapes.corners,
                Ray{localPoint(pose, from), unrotate(pose.rotation, displacement)});
    if (!hit) return std::nullopt;
    return CastHit{.shape = idOf(world, shape),
                   .body = bodyOf(world, idOf(world, shape)),
                   .point = from + displacement * hit->fraction,
                   .normal = rotate(pose.rotation, hit->normal),
                   .fraction = hit->fraction,
                   .distance = hit->fraction * length(displacement)};
}

}  // namespace

std::optional<CastHit> castRay(World& world, WorldPosition from, Vec2 displacement,
                               const QueryFilter& filter) {
    return firstHit(candidatesOf(world, from, displacement, filter),
                    [&](std::uint32_t shape) { return hitOf(world, shape, from, displacement); });
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
    allHits(
        candidatesOf(world, from, displacement, filter),
        [&](std::uint32_t shape) { return hitOf(world, shape, from, displacement); }, hits);
}

}  // namespace plumb::physics
