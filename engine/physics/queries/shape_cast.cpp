#include "physics/queries/shape_cast.hpp"

#include "physics/queries/candidates.hpp"
#include "physics/queries/moving_outline.hpp"

namespace plumb::physics {

namespace {

std::span<const std::uint32_t> candidatesOf(World& world, const QueryShape& shape, Vec2 displacement,
                                            const QueryFilter& filter) {
    const AABB bounds = boundsOf(world, shape);
    return candidatesAlong(world, shape.position + bounds.center(), displacement, 0.5f * bounds.size(),
                           filter);
}

std::optional<CastHit> hitOf(const World& world, std::uint32_t shape, const MovingOutline& moving) {
    return meet(world, shape, poseOf(world, shape), moving);
}

MovingOutline outlineOf(const World& world, const QueryShape& shape, Vec2 displacement) {
    return {convexOf(shape.geometry, cornersOf(world, shape)), shape.position, shape.rotation, displacement};
}

}  // namespace

std::optional<CastHit> castShape(World& world, const QueryShape& shape, Vec2 displacement,
                                 const QueryFilter& filter) {
    if (!isUsable(world, shape) || !isUsable(displacement)) return std::nullopt;
    const MovingOutline moving = outlineOf(world, shape, displacement);
    std::optional<CastHit> first;
    for (const std::uint32_t other : candidatesOf(world, shape, displacement, filter)) {
        const auto hit = hitOf(world, other, moving);
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
        if (const auto hit = hitOf(world, other, moving)) hits.push_back(*hit);
    }
    sortByFraction(hits);
}

}  // namespace plumb::physics
