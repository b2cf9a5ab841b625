#include "app/game.hpp"

#include "app/effect_rows.hpp"
#include "app/engine_types.hpp"
#include "app/step_clock.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

Game::Game()
    : types{engineTypes()}, world{types}, input{world.resource<Input>()}, effects{engineEffects(), world} {
    world.provide(assets);
    world.provide(threads);
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
