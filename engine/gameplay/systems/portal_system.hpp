#pragma once

#include <string_view>

namespace plumb {

class World;

/// Takes bodies from portals to where they lead.
/// Reads: trigger events, Portal. Writes: Transform, RigidBody.
/// When: after physics.
struct PortalSystem {
    static constexpr std::string_view kName = "portals";

    void update(World& world, float dt);
};

}  // namespace plumb
