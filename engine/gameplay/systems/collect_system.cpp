#include "gameplay/systems/collect_system.hpp"

#include <algorithm>

#include "ecs/hierarchy.hpp"
#include "ecs/world.hpp"
#include "gameplay/components/actors/health.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/triggers/collectible.hpp"
#include "gameplay/components/triggers/lifetime.hpp"
#include "gameplay/game_progress.hpp"
#include "gameplay/sound_cue.hpp"
#include "gameplay/touches.hpp"
#include "scene/components/drawing/particle_emitter.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

namespace {

void count(World& world, const Collectible& collectible, EntityId player) {
    GameProgress& progress = world.resource<GameProgress>();
    switch (collectible.kind) {
        case CollectibleKind::Coin:
            progress.coins += collectible.value;
            progress.levelCoins += collectible.value;
            break;
        case CollectibleKind::Key: progress.keys += collectible.value; break;
        case CollectibleKind::Heart:
            if (auto* health = world.find<Health>(player)) {
                health->points = std::min(health->points + collectible.value, health->most);
            }
            break;
    }
}

/// Detaches an emitter from its parent, plays it, and destroys it after its last particle.
void detachEmitter(World& world, EntityId child) {
    const Pose pose = worldPose(world, child);
    setParent(world, child, {});
    world.add<Transform>(child, Transform{pose.position, pose.rotation, pose.scale});
    auto& emitter = world.get<ParticleEmitter>(child);
    emitter.playing = true;
    world.add<Lifetime>(child).seconds =
        emitter.duration + emitter.lifetime * (1.0f + emitter.lifetimeSpread);
}

EntityId emitterBelow(World& world, EntityId item) {
    for (const EntityId child : childrenOf(world, item)) {
        if (world.has<ParticleEmitter>(child)) return child;
    }
    return {};
}

}  // namespace

void CollectSystem::update(World& world, float) {
    forEachTouch<TriggerEntered, Collectible, PlayerController>(world, [&](EntityId item, EntityId player) {
        count(world, std::as_const(world).get<Collectible>(item), player);
        playCue(world, item, &SoundCues::collect);
        // Emitters that are children of the item outlive it, so that their particles are seen.
        for (EntityId child; (child = emitterBelow(world, item)) != EntityId{};) detachEmitter(world, child);
        world.destroy(item);
    });
}

}  // namespace plumb
