#pragma once

#include <string_view>

namespace plumb {

class World;

/// Opens the project's pause scene as an overlay when the player presses Pause in a scene with a
/// PlayerController. Reads: Input, PlayerController, PauseScene. Writes: SceneRequests. When: after the other
/// systems that request scene changes, which have priority.
struct PauseSystem {
    static constexpr std::string_view kName = "pause";

    void update(World& world, float dt);
};

}  // namespace plumb
