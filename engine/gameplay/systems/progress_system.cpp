#include "gameplay/systems/progress_system.hpp"

#include <algorithm>

#include "ecs/world.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/triggers/collectible.hpp"
#include "gameplay/game_progress.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb {

namespace {

int coinsIn(const World& world) {
    int coins = 0;
    for (auto [entity, item] : world.query<const Collectible>()) {
        if (item.kind == CollectibleKind::Coin) coins += item.value;
    }
    return coins;
}

void enterLevel(World& world, GameProgress& progress, TextId level) {
    progress.level = level;
    progress.levelCoins = 0;
    progress.levelCoinsTotal = coinsIn(world);
    progress.levelFinished = false;
    progress.keys = 0;
    const auto& reached = progress.levelsReached;
    if (std::find(reached.begin(), reached.end(), level) != reached.end() || reached.full()) return;
    progress.levelsReached.push(level);
    progress.coinsTotal += progress.levelCoinsTotal;
}

/// Returns the scene of the player; empty if there is none.
TextId levelOfPlayer(World& world) {
    const Entity player = world.first<const PlayerController>();
    const auto* scene = player ? std::as_const(world).find<SceneEntity>(player) : nullptr;
    return scene != nullptr ? scene->scene.path : TextId{};
}

}  // namespace

void beginLevel(World& world) {
    const TextId level = levelOfPlayer(world);
    if (level.empty()) return;
    GameProgress& progress = world.resource<GameProgress>();
    if (level == progress.level && !progress.levelFinished)
        progress.coins = std::max(0, progress.coins - progress.levelCoins);
    enterLevel(world, progress, level);
}

void ProgressSystem::update(World& world, float) {
    const Entity player = world.first<const PlayerController>();
    if (!player) return;
    GameProgress& progress = world.resource<GameProgress>();
    const TextId level = levelOfPlayer(world);
    if (!level.empty() && !(level == progress.level)) enterLevel(world, progress, level);
    if (!progress.levelFinished) ++progress.ticks;
}

}  // namespace plumb
