#pragma once

#include <string_view>

namespace plumb {

class World;

/// Tells state machines how characters move: the parameters speed, grounded, vy, dead and hurt, where they
/// exist. Turns the picture to where the player faces.
/// Reads: RigidBody, KinematicBody, PlayerController, Health. Writes: Animator, Sprite; emits PlaySound at
/// steps.
/// When: after physics, before animation.
struct CharacterAnimationSystem {
    static constexpr std::string_view kName = "character animation";

    void update(World& world, float dt);
};

}  // namespace plumb
