#pragma once

#include <string_view>

namespace plumb {

class World;

/// Puts the bodies of an Experiment back where they began when that is asked for.
/// Reads: Input, Lab. Writes: Transform, RigidBody, Lab.
/// When: after sliders, before physics.
struct ExperimentSystem {
    static constexpr std::string_view kName = "experiments";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
