#pragma once

#include <string_view>

namespace plumb {

class World;

/// Ends the level for the player that touches its goal, and follows links of titles and endings.
/// Reads: TriggerEntered, Input. Writes: Goal, SceneLink, GameProgress, SceneRequests.
/// Emits: PlaySound. When: after physics.
struct GoalSystem {
    static constexpr std::string_view kName = "goal";

    void update(World& world, float dt);
};

}  // namespace plumb
