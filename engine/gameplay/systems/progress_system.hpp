#pragma once

#include <string_view>

namespace plumb {

class World;

/// Updates play time, entered levels and total coins of the GameProgress.
/// Reads: PlayerController, SceneEntity, Collectible. Writes: GameProgress.
/// When: before all other systems of this layer.
struct ProgressSystem {
    static constexpr std::string_view kName = "progress";

    void update(World& world, float dt);
};

/// Enters the level of the player's scene. Call after a scene was opened, so
/// that labels are correct from the first frame on. If a level is restarted
/// before its goal was touched, the coins collected in it are subtracted.
void beginLevel(World& world);

}  // namespace plumb
