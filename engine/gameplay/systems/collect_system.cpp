#include "gameplay/systems/collect_system.hpp"

#include <algorithm>

#include "ecs/world.hpp"
#include "gameplay/components/collectible.hpp"
#include "gameplay/components/health.hpp"
#include "gameplay/components/player_controller.hpp"
#include "gameplay/game_progress.hpp"
#include "gameplay/sound_cue.hpp"
#include "gameplay/touches.hpp"

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

}  // namespace

void CollectSystem::update(World& world, float) {
    forEachTouch<TriggerEntered, Collectible, PlayerController>(world, [&](EntityId item, EntityId player) {
        count(world, std::as_const(world).get<Collectible>(item), player);
        playCue(world, item, &SoundCues::collect);
        world.destroy(item);
    });
}

}  // namespace plumb
