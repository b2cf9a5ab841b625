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

}  // namespace plumb
