#include <gtest/gtest.h>

#include "ecs/world.hpp"
#include "gameplay/game_functions.hpp"
#include "gameplay/systems/motion_decor_system.hpp"
#include "scene/components/transform.hpp"
#include "scene/particles.hpp"
#include "scene/systems/particle_system.hpp"

namespace plumb {
namespace {

constexpr float kTick = 1.0f / 60.0f;  // s

std::size_t aliveIn(World& world) { return world.resource<Particles>().alive(); }

TEST(Burst, theParticlesComeAtOnceAndTheEntityGoesAfterTheLastOfThem) {
    for (const float lifetime : {0.1f, 0.5f, 0.9f}) {
        World world;
        world.addSystem<MotionDecorSystem>();
        world.addSystem<ParticleSystem>();
        ParticleEmitter emitter;
        emitter.lifetime = lifetime;
        emitter.lifetimeSpread = 0.4f;
        emitter.rate = 500.0f;
        emitter.loop = emitter.prewarm = true;
        const Entity made = burst(world, {30.0f, 40.0f}, 25, emitter);
        EXPECT_EQ(made.get<Transform>().position, (Vec2{30.0f, 40.0f}));
        std::size_t before = 25;
        int ticks = 0;
        while (made) {
            world.beginTick();
            world.update(kTick);
            if (!made) break;
            const std::size_t alive = aliveIn(world);
            EXPECT_TRUE(ticks > 0 || alive == 25u) << alive;
            EXPECT_LE(alive, before) << "no more than the first come";
            before = alive;
            ASSERT_LT(++ticks, 120);
        }
        EXPECT_EQ(before, 0u) << "the entity was destroyed before its last particle was gone";
        EXPECT_LT(static_cast<float>(ticks) * kTick, lifetime * 1.4f + 0.07f);
        EXPECT_EQ(world.entityCount(), 0u);
    }
}

}  // namespace
}  // namespace plumb
