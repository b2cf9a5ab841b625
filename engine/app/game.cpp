#include "app/game.hpp"

#include <utility>

#include "app/game_content.hpp"
#include "app/step_clock.hpp"
#include "gameplay/game_functions.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/files/prefab.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

Game::Game() : Game{engineContent()} {}

Game::Game(const GameContent& gameContent)
    : content{gameContent},
      types{content.types()},
      world{types},
      input{world.resource<Input>()},
      effects{content.effects(), world} {
    world.provide(assets);
    world.provide(threads);
    world.provide(content.scripts());
    content.scripts().addTexts(world);
}

Game::~Game() = default;

Random& Game::random() { return randomOf(world); }
void Game::play(SoundId sound, float volume) { playSound(world, sound, volume); }
Entity Game::find(std::string_view name) { return findEntity(world, name); }
Vec2 Game::mouseInWorld() { return plumb::mouseInWorld(world); }
void Game::show(std::string_view word, std::string_view text) { showText(world, word, text); }

Entity Game::spawn(std::string_view prefab, Vec2 place) {
    if (world.service<PrefabLibrary>() == nullptr) {
        spawned_ = std::make_unique<PrefabLibrary>(types, assets.root());
        world.provide(*spawned_);
    }
    return plumb::spawn(world, prefab, place);
}

Sprite Game::wholePicture(TextureId texture, int width, int height) {
    Sprite sprite{texture, width, height};
    if (const Texture* picture = assets.find(texture))
        sprite.source = {0.0f, 0.0f, static_cast<float>(picture->width), static_cast<float>(picture->height)};
    return sprite;
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
