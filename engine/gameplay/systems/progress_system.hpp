#pragma once

#include <string_view>

namespace plumb {

class World;

/// Counts the time, the levels and the coins that there are.
/// Reads: PlayerController, SceneEntity, Collectible. Writes: GameProgress.
/// When: before all others of this layer.
struct ProgressSystem {
    static constexpr std::string_view kName = "progress";

    void update(World& world, float dt);
};

/// After a scene was opened: it is the level that its player is in, and its numbers are shown from the first
/// picture on. A level that is begun anew before its goal gives back the coins taken in it.
void beginLevel(World& world);

}  // namespace plumb
