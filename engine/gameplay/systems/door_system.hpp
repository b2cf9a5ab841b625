#pragma once

#include <string_view>

namespace plumb {

class World;

/// Opens doors by keys and buttons.
/// Reads: ContactBegan, TriggerStayed. Writes: Button, Door, GameProgress, BoxCollider, Sprite.
/// When: after physics.
struct DoorSystem {
    static constexpr std::string_view kName = "door";

    void update(World& world, float dt);
};

}  // namespace plumb
