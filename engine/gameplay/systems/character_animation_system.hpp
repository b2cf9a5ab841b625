#pragma once

#include <string_view>

namespace plumb {

class World;

/// Sets those of the animation parameters speed, vy, grounded, dead and hurt that exist for a character.
/// Flips the player's sprite to its facing direction. Reads: RigidBody, KinematicBody, PlayerController,
/// Health. Writes: Animator, Sprite. When: after physics, before animation.
struct CharacterAnimationSystem {
    static constexpr std::string_view kName = "character animation";

    void update(World& world, float dt);
};

}  // namespace plumb
