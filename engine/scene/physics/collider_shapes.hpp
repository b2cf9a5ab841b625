#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/result.hpp"
#include "ecs/world.hpp"
#include "physics/model/shapes.hpp"
#include "scene/physics/physics_units.hpp"

namespace plumb {

struct RigidBody;

// From collider components to shapes. All colliders of an entity are parts of its body.

inline constexpr float kDefaultFriction = 0.6f;  ///< of colliders without a RigidBody

/// px: a size that an entity is drawn with; mirrored ones are as large.
[[nodiscard]] inline Vec2 scaledSize(float width, float height, Vec2 scale) {
    return {width * std::abs(scale.x), height * std::abs(scale.y)};
}

/// A number for the outlines of an entity's colliders: while it stays, so do their shapes. 0 without
/// collider.
[[nodiscard]] std::uint64_t outlinesOf(const World& world, EntityId entity, Vec2 scale);

/// Gives a body the shapes of an entity's colliders in place of those that it had.
/// @param scale  ratio: the entity's size in the world
/// @error what is wrong with a collider; the body has no shapes of it then
Result<Done> makeShapes(physics::World& bodies, physics::BodyId body, const World& world, EntityId entity,
                        Vec2 scale, PixelScale units);

/// Brings friction and the like of the shapes of a body up to date, which costs no contact.
/// @param rigid  may be null
Result<Done> updateSurfaces(physics::World& bodies, physics::BodyId body, const World& world, EntityId entity,
                            const RigidBody* rigid, PixelScale units);

/// Grows whenever some entity gets or loses a collider.
[[nodiscard]] std::uint64_t colliderMembers(const World& world);
[[nodiscard]] bool hasColliders(const World& world);

/// Where an entity has a collider, its place among all that have one: by kind, then in the order of queries.
[[nodiscard]] std::optional<std::uint64_t> colliderOrder(const World& world, EntityId entity);

/// Calls `visit(EntityId)` for every collider that may have been written since the mark, also where its
/// entity is paused.
void forEachChangedCollider(const World& world, std::uint64_t mark,
                            void (*visit)(void* context, EntityId entity), void* context);

}  // namespace plumb
