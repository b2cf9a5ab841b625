#include "gameplay/systems/spring_system.hpp"

#include <algorithm>
#include <cmath>

#include "ecs/world.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/triggers/spring.hpp"
#include "gameplay/sound_cue.hpp"
#include "gameplay/touches.hpp"
#include "scene/components/bodies/rigid_body.hpp"

namespace plumb {

namespace {

constexpr int kPressedTicks = 12;  // value of Spring::pressed after a launch

void throwUp(World& world, EntityId springId, EntityId other) {
    Spring& spring = world.get<Spring>(springId);
    RigidBody& body = world.get<RigidBody>(other);
    if (spring.onlyFromAbove && body.velocity.y < 0.0f) return;
    if (spring.pressed > kPressedTicks / 2) return;  // it has just launched a body
    if (spring.speed.x != 0.0f) body.velocity.x = spring.speed.x;
    if (spring.speed.y != 0.0f) body.velocity.y = spring.speed.y;
    body.grounded = false;
    if (auto* player = world.find<PlayerController>(other))
        player->hold = player->coyote = player->buffer = 0;
    spring.pressed = kPressedTicks;
    setParameter(world, springId, "pressed", 1.0f);
    playCue(world, springId, &SoundCues::bounce);
}

}  // namespace

void SpringSystem::update(World& world, float) {
    world.each<Spring>([](Spring& spring) { spring.pressed = std::max(spring.pressed - 1, 0); });
    const auto visit = [&world](EntityId spring, EntityId other) { throwUp(world, spring, other); };
    forEachTouch<TriggerEntered, Spring, RigidBody>(world, visit);
    forEachTouch<TriggerStayed, Spring, RigidBody>(world, visit);
}

}  // namespace plumb
