#pragma once

#include <string_view>

#include "ecs/world.hpp"

namespace plumb {

/// The size of the game's picture, for what must know how much is seen. Set when a game starts.
struct PictureSize {
    Vec2 size{1280.0f, 720.0f};  ///< px

    void addTo(Hasher& hasher) const { hasher.add(size.x), hasher.add(size.y); }
};

/// Moves every enabled Camera after what it follows. Reads Transform and RigidBody of the followed, writes
/// the camera's Transform; after everything that moves.
struct CameraSystem {
    static constexpr std::string_view kName = "camera";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
