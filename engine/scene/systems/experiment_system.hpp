#pragma once

#include <string_view>

namespace plumb {

class World;

/// Restores the initial state of an Experiment's bodies when its action is pressed or a slider was released.
/// Reads: Input, Lab. Writes: Transform, RigidBody, Lab.
/// When: after sliders, before physics.
struct ExperimentSystem {
    static constexpr std::string_view kName = "experiments";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
