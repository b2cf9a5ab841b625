#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

// Entities and their bodies: which belongs to which, and their places in pixels and in metres.

/// Puts an entity at a pose in the world (px), through the pose of its parent if it has one. Its scale stays.
void placeEntity(World& world, EntityId entity, const Pose& pose);

/// Warns once per entity: a broken one would fill the log. The line names it as "crate @9f3c1a77d2e0b154", by
/// the id that its scene's file has, so that the editor's console finds it.
void tellRefusal(const World& world, PhysicsState& state, EntityId entity, const Error& error);

[[nodiscard]] constexpr std::uint64_t userOf(EntityId entity) {
    return std::uint64_t{entity.index} << 32 | entity.generation;
}
/// Whose body it is, also when it was destroyed in this tick.
[[nodiscard]] inline EntityId ownerOf(const PhysicsState& state, physics::BodyId body) {
    const std::uint64_t user = state.world.bodies.info[body.index].user;
    return {static_cast<std::uint32_t>(user >> 32), static_cast<std::uint32_t>(user)};
}
/// The entity's own body, or the empty id.
[[nodiscard]] physics::BodyId bodyOf(const PhysicsState& state, EntityId entity);

[[nodiscard]] inline physics::WorldPosition placeInMetres(Vec2 pixels, PixelScale scale) {
    return {static_cast<double>(pixels.x) * static_cast<double>(scale.metres),
            static_cast<double>(pixels.y) * static_cast<double>(scale.metres)};
}
[[nodiscard]] inline Vec2 placeInPixels(physics::WorldPosition metres, PixelScale scale) {
    return {static_cast<float>(metres.x * static_cast<double>(scale.pixels)),
            static_cast<float>(metres.y * static_cast<double>(scale.pixels))};
}

}  // namespace plumb
