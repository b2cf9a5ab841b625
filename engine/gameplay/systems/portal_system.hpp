#pragma once

#include <string_view>

namespace plumb {

class World;

/// Teleports bodies that enter a Portal.
/// Reads: trigger events, Portal. Writes: Transform, RigidBody.
/// When: after physics.
struct PortalSystem {
    static constexpr std::string_view kName = "portals";

    void update(World& world, float dt);
};

}  // namespace plumb
