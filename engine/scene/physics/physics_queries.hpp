#pragma once

#include <optional>
#include <vector>

#include "ecs/world.hpp"
#include "math/rect.hpp"

namespace plumb {

/// Which colliders a query sees.
struct QueryFilter {
    std::uint32_t layers = 1;          ///< bits: what the query is, for the masks of others
    std::uint32_t mask = 0xffffffffu;  ///< bits: what it meets
    EntityId except;                   ///< empty, or one that it does not see
    bool triggers = false;             ///< triggers too
    bool oneWay = true;                ///< one-way surfaces too, from above
    bool movers = true;                ///< bodies that move too
};

struct QueryHit {
    EntityId entity;
    Vec2 normal;              ///< length 1, away from what was hit
    Vec2 point;               ///< px
    float fraction = 0.0f;    ///< of the way, 0..1
    float separation = 0.0f;  ///< px along the normal at the start; negative when they overlapped
};

/// The first collider that a box meets on a straight way (px). What it only leaves or slides along does
/// not count.
std::optional<QueryHit> castBox(World& world, const AABB& box, Vec2 way, const QueryFilter& filter = {});

/// The first collider on a line from `from` along `way` (px).
std::optional<QueryHit> castRay(World& world, Vec2 from, Vec2 way, const QueryFilter& filter = {});

/// How far the body of an entity goes in this tick (px), as far as it is known before the step.
Vec2 tickMotionOf(World& world, EntityId entity, float dt);

/// All entities whose colliders overlap the box, each once, in a fixed order.
void overlapBox(World& world, const AABB& box, const QueryFilter& filter, std::vector<EntityId>& found);

}  // namespace plumb
