#pragma once

#include <string_view>

namespace plumb {

class World;

/// Records the values that plots show.
/// Reads: PhysicsState, GhostWorlds, Plot. Writes: PlotPast.
/// When: after ghosts.
struct PlotSystem {
    static constexpr std::string_view kName = "plots";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
