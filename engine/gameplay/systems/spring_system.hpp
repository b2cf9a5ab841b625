#pragma once

#include <string_view>

namespace plumb {

class World;

/// Throws up what touches a spring.
/// Reads: TriggerEntered, TriggerStayed. Writes: RigidBody, Animator; emits PlaySound.
/// When: after physics.
struct SpringSystem {
    static constexpr std::string_view kName = "spring";

    void update(World& world, float dt);
};

}  // namespace plumb
