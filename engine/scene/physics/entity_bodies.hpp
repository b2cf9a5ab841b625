#pragma once

#include <string>

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

// Mapping between entities and bodies, and between positions in pixels and in metres.

/// Sets an entity's Transform so that it has this world pose (px). The scale is not changed.
/// @param poses  poses of this world, up to date
void placeEntity(World& world, WorldPoses& poses, EntityId entity, const Pose& pose);

/// Returns how messages call an entity: by its name and stable id, e.g. "crate @9f3c1a77d2e0b154", by which
/// the editor's console finds it; one that code created by its index, "crate (entity 12)".
std::string describedEntity(const World& world, EntityId entity);

/// Logs an error of an entity's physics components in the words of gameError() and with the entity; once for
/// each Error::where and EntityId::index until Reports::forget(), so that entities which come and go each
/// tick do not fill the log.
void logRefusal(const World& world, const PhysicsState& state, EntityId entity, const Error& error);

/// Returns the user data of the physics objects that belong to an entity; see ownerOf().
[[nodiscard]] constexpr std::uint64_t userOf(EntityId entity) {
    return std::uint64_t{entity.index} << 32 | entity.generation;
}
/// Returns the entity that a body belongs to, even if it was destroyed in this tick.
[[nodiscard]] inline EntityId ownerOf(const PhysicsState& state, physics::BodyId body) {
    const std::uint64_t user = state.world.bodies.info[body.index].user;
    return {static_cast<std::uint32_t>(user >> 32), static_cast<std::uint32_t>(user)};
}
/// Returns the body of an entity, or the empty id.
[[nodiscard]] physics::BodyId bodyOf(const PhysicsState& state, EntityId entity);

[[nodiscard]] inline physics::WorldPosition positionInMetres(Vec2 pixels, PixelScale scale) {
    return {static_cast<double>(pixels.x) * static_cast<double>(scale.metres),
            static_cast<double>(pixels.y) * static_cast<double>(scale.metres)};
}
[[nodiscard]] inline Vec2 positionInPixels(physics::WorldPosition metres, PixelScale scale) {
    return {static_cast<float>(metres.x * static_cast<double>(scale.pixels)),
            static_cast<float>(metres.y * static_cast<double>(scale.pixels))};
}

}  // namespace plumb
