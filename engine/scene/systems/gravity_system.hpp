#pragma once

#include <string_view>

namespace plumb {

class World;

/// Calls for gravity: velocities of rigid bodies grow. The step itself runs once a tick, in the last of the
/// physics systems.
struct GravitySystem {
    static constexpr std::string_view kName = "gravity";

    void update(World& world, float dt);
};

}  // namespace plumb
