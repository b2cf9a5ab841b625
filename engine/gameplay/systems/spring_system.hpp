#pragma once

#include <string_view>

namespace plumb {

class World;

/// Launches bodies that touch a Spring.
/// Reads: TriggerEntered, TriggerStayed. Writes: Spring, RigidBody, Animator; emits PlaySound.
/// When: after physics.
struct SpringSystem {
    static constexpr std::string_view kName = "spring";

    void update(World& world, float dt);
};

}  // namespace plumb
