#include "gameplay/systems/hazard_system.hpp"

#include <algorithm>

#include "ecs/world.hpp"
#include "gameplay/components/actors/health.hpp"
#include "gameplay/components/actors/patrol.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "gameplay/components/actors/stompable.hpp"
#include "gameplay/components/triggers/hazard.hpp"
#include "gameplay/components/triggers/kill_plane.hpp"
#include "gameplay/components/triggers/lifetime.hpp"
#include "gameplay/harm.hpp"
#include "gameplay/sound_cue.hpp"
#include "gameplay/touches.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/transform.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

namespace {

constexpr float kStompDepth = 0.6f;  // ratio of the enemy's height, from its top, in which the feet must be

/// True if the player falls and its feet were above the lower part of the enemy before this tick.
bool comesFromAbove(World& world, EntityId enemy, EntityId player) {
    if (!world.has<BoxCollider>(enemy) || !world.has<BoxCollider>(player)) return false;
    const auto* body = std::as_const(world).find<RigidBody>(player);
    if (body == nullptr || body->velocity.y <= 0.0f) return false;
    const AABB head = boxOf(world, enemy);
    const Transform& transform = std::as_const(world).get<Transform>(player);
    const float rise = transform.position.y - transform.previousPosition.y;
    return boxOf(world, player).max.y - rise <= head.min.y + head.size().y * kStompDepth;
}

void stomp(World& world, EntityId enemy, EntityId player) {
    const Stompable stompable = std::as_const(world).get<Stompable>(enemy);
    RigidBody& body = world.get<RigidBody>(player);
    body.velocity.y = -stompable.bounce;
    body.grounded = false;
    if (auto* controller = world.find<PlayerController>(player))
        controller->hold = controller->jumpHoldTicks / 2;
    playCue(world, enemy, &SoundCues::bounce);
    setParameter(world, enemy, "stomped", 1.0f);
    world.remove<BoxCollider>(enemy);
    world.remove<Patrol>(enemy);
    world.remove<Hazard>(enemy);
    world.remove<Stompable>(enemy);
    if (auto* kinematic = world.find<KinematicBody>(enemy)) kinematic->velocity = {};
    world.add<Lifetime>(enemy).seconds = stompable.lingers;
}

void touch(World& world, EntityId hazardId, EntityId other) {
    if (world.has<PlayerController>(other) && world.has<Stompable>(hazardId) &&
        comesFromAbove(world, hazardId, other)) {
        stomp(world, hazardId, other);
        return;
    }
    if (!world.has<PlayerController>(other) && world.has<Stompable>(hazardId))
        return;  // enemies do not hurt enemies
    const Hazard hazard = std::as_const(world).get<Hazard>(hazardId);
    const bool left = worldPose(world, other).position.x < worldPose(world, hazardId).position.x;
    hurt(world, other, hazard.damage, {left ? -hazard.knockback.x : hazard.knockback.x, hazard.knockback.y});
}

void killBelow(World& world, float limit) {
    for (auto [entity, health] : world.query<const Health>(with<Transform>)) {
        if (worldPose(world, entity.id()).position.y > limit) kill(world, entity);
    }
    for (auto [entity, body] :
         world.query<const RigidBody>(with<Transform>, without<Health, PlayerController>)) {
        if (worldPose(world, entity.id()).position.y > limit) entity.destroy();
    }
}

}  // namespace

void HazardSystem::update(World& world, float) {
    const auto visit = [&world](EntityId hazard, EntityId other) { touch(world, hazard, other); };
    forEachTouch<TriggerEntered, Hazard, Health>(world, visit);
    forEachTouch<TriggerStayed, Hazard, Health>(world, visit);
    for (auto [entity, plane] : world.query<const KillPlane>(with<Transform>))
        killBelow(world, worldPose(world, entity.id()).position.y);
}

}  // namespace plumb
