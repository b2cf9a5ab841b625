#pragma once

#include <optional>
#include <vector>

#include "ecs/world.hpp"
#include "math/rect.hpp"

namespace plumb {

/// Selects the colliders that a query considers.
struct QueryFilter {
    std::uint32_t layers = 1;          ///< bits: layers of the query; a collider's mask must have one of them
    std::uint32_t mask = 0xffffffffu;  ///< bits: layers of the colliders that the query considers
    EntityId except;                   ///< entity to ignore; may be empty
    bool triggers = false;             ///< include triggers
    bool oneWay = true;                ///< include one-way surfaces, hit from above
    bool movers = true;                ///< include dynamic and kinematic bodies
};

struct QueryHit {
    EntityId entity;
    Vec2 normal;              ///< length 1, outward from the collider
    Vec2 point;               ///< px
    float fraction = 0.0f;    ///< fraction of the displacement, 0..1
    float separation = 0.0f;  ///< px, distance along the normal at the start; negative: overlap
};

/// Returns the first collider that a box hits when moved by `way` (px). Colliders that it only leaves or
/// slides along are ignored.
std::optional<QueryHit> castBox(World& world, const AABB& box, Vec2 way, const QueryFilter& filter = {});

/// Returns the first collider that a ray from `from` to `from + way` (px) hits.
std::optional<QueryHit> castRay(World& world, Vec2 from, Vec2 way, const QueryFilter& filter = {});

/// Returns the collision layers of all colliders of an entity (bits), e.g. of one that a contact names; 0
/// without a collider.
std::uint32_t collisionLayersOf(const World& world, EntityId entity);

/// Returns the displacement of an entity's body in this
/// tick (px), as its velocity before the step predicts it.
Vec2 tickMotionOf(World& world, EntityId entity, float dt);

/// Fills `found` with the entities whose colliders overlap the
/// box (px), without duplicates, in a deterministic order.
void overlapBox(World& world, const AABB& box, const QueryFilter& filter, std::vector<EntityId>& found);

/// Fills `found` with the entities that an entity touched in the last physics step, also while they sleep:
/// solid colliders, and triggers or what is inside of them. Without duplicates, sorted by id. ContactBegan
/// and TriggerEntered tell when a touch begins. Cost: linear in the number of contacts in the world.
void touchesOf(const World& world, EntityId entity, std::vector<EntityId>& found);

/// True if two entities touched in the last physics step, as touchesOf().
bool isTouching(const World& world, EntityId a, EntityId b);

}  // namespace plumb
