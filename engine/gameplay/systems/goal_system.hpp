#pragma once

#include <string_view>

namespace plumb {

class World;

/// Completes the level when a player touches a Goal, and performs the scene changes of SceneLinks.
/// Reads: TriggerEntered, Input. Writes: Goal, SceneLink, GameProgress, SceneRequests.
/// Emits: PlaySound. When: after physics.
struct GoalSystem {
    static constexpr std::string_view kName = "goal";

    void update(World& world, float dt);
};

}  // namespace plumb
