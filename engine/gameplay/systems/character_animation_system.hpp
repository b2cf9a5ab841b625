#pragma once

#include <string_view>

namespace plumb {

class World;

/// Sets the state machine parameters speed, vy, grounded, dead and hurt of characters, if they exist. Flips
/// the player's sprite to its facing direction. Reads: RigidBody, KinematicBody, PlayerController, Health.
/// Writes: Animator, Sprite. When: after physics, before animation.
struct CharacterAnimationSystem {
    static constexpr std::string_view kName = "character animation";

    void update(World& world, float dt);
};

}  // namespace plumb
