#include "gameplay/systems/character_animation_system.hpp"

#include <cmath>

#include "ecs/world.hpp"
#include "gameplay/components/actors/health.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/touches.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/drawing/animator.hpp"
#include "scene/components/drawing/sprite.hpp"

namespace plumb {

void CharacterAnimationSystem::update(World& world, float) {
    for (auto [entity, body] : world.query<const RigidBody>(with<Animator>)) {
        setParameter(world, entity, "speed", std::abs(body.velocity.x));
        setParameter(world, entity, "vy", body.velocity.y);
        setParameter(world, entity, "grounded", body.grounded ? 1.0f : 0.0f);
    }
    for (auto [entity, body] : world.query<const KinematicBody>(with<Animator>, without<RigidBody>)) {
        setParameter(world, entity, "speed", std::abs(body.velocity.x));
    }
    for (auto [entity, health] : world.query<const Health>(with<Animator>)) {
        setParameter(world, entity, "dead", health.points <= 0 ? 1.0f : 0.0f);
        setParameter(world, entity, "hurt", health.safe > 0 ? 1.0f : 0.0f);
    }
    for (auto [entity, player, sprite] : world.query<const PlayerController, Sprite>()) {
        sprite.flipX = player.facing < 0;
    }
}

}  // namespace plumb
