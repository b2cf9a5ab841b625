#include "gameplay/harm.hpp"

#include <algorithm>

#include "gameplay/components/actors/health.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "gameplay/game_progress.hpp"
#include "gameplay/sound_cue.hpp"
#include "math/portable.hpp"
#include "scene/components/bodies/rigid_body.hpp"

namespace plumb {

namespace {

/// Handles the death of an entity: with a Respawn it waits to respawn, otherwise it is destroyed.
void die(World& world, EntityId entity) {
    playCue(world, entity, &SoundCues::die);
    if (world.has<PlayerController>(entity)) ++world.resource<GameProgress>().deaths;
    Respawn* respawn = world.find<Respawn>(entity);
    if (respawn == nullptr) {
        world.destroy(entity);
        return;
    }
    respawn->waiting = std::max(floorToInt(respawn->delay * 60.0f), 1);
    if (auto* body = world.find<RigidBody>(entity)) body->velocity = {};
}

}  // namespace

bool hurt(World& world, EntityId entity, int damage, Vec2 knockback) {
    Health* health = world.find<Health>(entity);
    if (health == nullptr || health->safe > 0 || health->points <= 0) return false;
    health->points = std::max(health->points - damage, 0);
    if (health->points == 0) return die(world, entity), true;
    health->safe = health->safeTicks;
    playCue(world, entity, &SoundCues::hurt);
    if (auto* body = world.find<RigidBody>(entity)) {
        body->velocity = knockback;
        body->grounded = false;
    }
    return true;
}

void kill(World& world, EntityId entity) {
    Health* health = world.find<Health>(entity);
    if (health == nullptr || health->points <= 0) return;
    health->points = 0;
    die(world, entity);
}

}  // namespace plumb
