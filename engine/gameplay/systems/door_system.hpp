#pragma once

#include <string_view>

namespace plumb {

class World;

/// Opens doors with keys and buttons, and closes them when buttons are released.
/// Reads: TriggerEntered, TriggerStayed, PlayerController. Writes: Button, Door, GameProgress, BoxCollider,
/// Sprite. When: after physics.
struct DoorSystem {
    static constexpr std::string_view kName = "door";

    void update(World& world, float dt);
};

}  // namespace plumb
