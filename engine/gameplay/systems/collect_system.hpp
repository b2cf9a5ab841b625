#pragma once

#include <string_view>

namespace plumb {

class World;

/// Lets players pick up the Collectibles they touch.
/// Reads: TriggerEntered. Writes: GameProgress, Health; destroys the Collectible; emits PlaySound.
/// When: after physics.
struct CollectSystem {
    static constexpr std::string_view kName = "collect";

    void update(World& world, float dt);
};

}  // namespace plumb
