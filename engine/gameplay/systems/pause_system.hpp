#pragma once

#include <string_view>

namespace plumb {

class World;

/// Lays the project's pause scene over a scene that is played.
/// Reads: Input, PlayerController, PauseScene. Writes: SceneRequests.
/// When: after what asks for other scenes, which goes first.
struct PauseSystem {
    static constexpr std::string_view kName = "pause";

    void update(World& world, float dt);
};

}  // namespace plumb
