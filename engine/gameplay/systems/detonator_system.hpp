#pragma once

#include <string_view>

namespace plumb {

class World;

/// Triggers the explosions of detonators.
/// Reads: Input. Writes: Detonator, Explosion. Emits: PlaySound.
/// When: before physics.
struct DetonatorSystem {
    static constexpr std::string_view kName = "detonators";

    void update(World& world, float dt);
};

}  // namespace plumb
