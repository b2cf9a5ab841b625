#include "app/game.hpp"

#include <utility>

#include "app/effect_rows.hpp"
#include "app/engine_types.hpp"
#include "app/step_clock.hpp"
#include "core/log.hpp"
#include "gameplay/label_values.hpp"
#include "scene/components/name.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/files/prefab.hpp"
#include "scene/play_sound.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

Game::Game()
    : types{engineTypes()}, world{types}, input{world.resource<Input>()}, effects{engineEffects(), world} {
    world.provide(assets);
    world.provide(threads);
}

Game::~Game() = default;

void Game::play(SoundId sound, float volume) { world.emit(PlaySound{sound, volume, {}, world.tick}); }

Entity Game::find(std::string_view name) {
    const TextId wanted = textId(name);
    EntityId first;
    for (auto [entity, named] : std::as_const(world).query<const Name>(withPaused)) {
        if (named.text == wanted && (!first || entity.id() < first)) first = entity.id();
    }
    return first ? world.entity(first) : Entity{};
}

Entity Game::spawn(std::string_view prefab, Vec2 place) {
    if (spawned_ == nullptr) spawned_ = std::make_unique<PrefabLibrary>(types, assets.root());
    const std::string inAssets = "assets/" + std::string{prefab};
    const Result<Path> file = assets.resolve(prefab);  // as other assets are found by a bare name
    const Result<Path> other = assets.resolve(inAssets);
    const bool lies = file && other && *file == *other;
    const Result<const Prefab*> found = spawned_->find(lies ? inAssets : prefab);
    if (!found) {
        logError("Scene", found.error());
        return {};
    }
    for (const Error& problem : (*found)->problems) logWarning("Scene", problem);
    return spawnPrefab(world, types, **found, place);
}

Vec2 Game::mouseInWorld() {
    return toWorld(cameraView(world, world.resource<PictureSize>().size, 1.0f), input.mouse());
}

Sprite Game::wholePicture(TextureId texture, int width, int height) {
    Sprite sprite{texture, width, height};
    if (const Texture* picture = assets.find(texture))
        sprite.source = {0.0f, 0.0f, static_cast<float>(picture->width), static_cast<float>(picture->height)};
    return sprite;
}

void Game::show(std::string_view word, std::string_view text) {
    world.resource<LabelValues>().set(word, text);
}

void tickGame(Game& game, const InputFrame& frame) {
    constexpr auto kDt = static_cast<float>(StepClock::kStep);
    World& world = game.world;
    world.beginTick();
    storePreviousTransforms(world);
    game.effects.followScenes(world);
    game.input.advance(frame);
    game.onUpdate(kDt);
    world.update(kDt);
    game.onLateUpdate(kDt);
}

}  // namespace plumb
