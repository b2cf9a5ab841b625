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

// Creates physics shapes from collider components. All colliders of an entity belong to its body.

inline constexpr float kDefaultFriction = 0.6f;  ///< friction of colliders without a RigidBody

/// Returns a size scaled by an entity's scale (px); a negative scale mirrors and does not change the size.
[[nodiscard]] inline Vec2 scaledSize(float width, float height, Vec2 scale) {
    return {width * std::abs(scale.x), height * std::abs(scale.y)};
}

/// Returns a hash of the outlines of an entity's colliders;
/// shapes are recreated when it changes. 0 without colliders.
[[nodiscard]] std::uint64_t outlinesOf(const World& world, EntityId entity, Vec2 scale);

/// Replaces the shapes of a body by those of an entity's colliders.
/// @param scale  world scale of the entity (ratio)
/// @error an invalid collider; the body gets no shape for it
Result<Done> makeShapes(physics::World& bodies, physics::BodyId body, const World& world, EntityId entity,
                        Vec2 scale, PixelScale units);

/// Updates friction, restitution, conveyor speed and filter of a body's shapes. Existing contacts are kept.
/// @param rigid  the entity's RigidBody; may be null
Result<Done> updateSurfaces(physics::World& bodies, physics::BodyId body, const World& world, EntityId entity,
                            const RigidBody* rigid, PixelScale units);

/// Returns a counter that is incremented whenever an entity gains or loses a collider.
[[nodiscard]] std::uint64_t colliderMembers(const World& world);
[[nodiscard]] bool hasColliders(const World& world);

/// Returns the collision layers of all colliders of an entity except tiles (bits).
[[nodiscard]] std::uint32_t shapeLayersOf(const World& world, EntityId entity);

/// Returns a sort key of an entity with a collider: by kind
/// of collider, then by query order. nullopt without one.
[[nodiscard]] std::optional<std::uint64_t> colliderOrder(const World& world, EntityId entity);

/// Calls `visit` for the entity of every collider that may have been
/// written since the change mark `mark`, including paused entities.
void forEachChangedCollider(const World& world, std::uint64_t mark,
                            void (*visit)(void* context, EntityId entity), void* context);

}  // namespace plumb
