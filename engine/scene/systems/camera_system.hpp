#pragma once

#include <string_view>

#include "ecs/world.hpp"

namespace plumb {

/// Size of the game image, for code that depends on the
/// visible area. A world resource, set when a game starts. The type's
/// name is part of the hash of a world: renaming it would invalidate the hashes in replay files.
struct PictureSize {
    static constexpr bool kNotSaved = true;

    Vec2 size{1280.0f, 720.0f};  ///< px

    void addTo(Hasher& hasher) const { hasher.add(size.x), hasher.add(size.y); }
};

/// Moves every enabled Camera towards the entity it follows.
/// Reads: Transform and RigidBody of the followed entity. Writes: Camera and its Transform.
/// When: after all systems that move entities.
struct CameraSystem {
    static constexpr std::string_view kName = "camera";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
