#pragma once

#include <string_view>

namespace plumb {

class World;

/// Requests the effect of gravity on rigid bodies. The physics step runs once per tick, in the last of the
/// physics systems that are present.
struct GravitySystem {
    static constexpr std::string_view kName = "gravity";

    void update(World& world, float dt);
};

}  // namespace plumb
