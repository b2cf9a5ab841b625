#pragma once

#include <string_view>

namespace plumb {

class World;

/// Applies the damage of hazards and kill planes, and lets players stomp enemies.
/// Reads: TriggerEntered, TriggerStayed, KillPlane. Writes: Health, RigidBody.
/// When: after physics and springs.
struct HazardSystem {
    static constexpr std::string_view kName = "hazard";

    void update(World& world, float dt);
};

}  // namespace plumb
