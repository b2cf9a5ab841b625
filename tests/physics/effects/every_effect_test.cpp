#include <string>

#include <gtest/gtest.h>

#include "tests/physics/support/effect_scenes.hpp"

// For each effect: a scene that does not require the effect does not run it, and a run of the effect without
// need changes no bit.

namespace plumb::physics {
namespace {

using namespace test;

constexpr float kTick = 1.0f / 60.0f;  // s

void run(World& world, int steps) {
    for (int i = 0; i < steps; ++i) step(world, kTick);
}

class EveryEffect : public testing::TestWithParam<Effect> {};

TEST_P(EveryEffect, isNotRunInASceneWithoutIt) {
    const Effect effect = GetParam();
    World world = makeSceneWithout(effect);
    run(world, 30);
    EXPECT_EQ(runsOf(world, effect), 0u);
    for (const StageInfo& stage : stages()) {
        if (stage.effects == Manifest::bit(effect)) {
            EXPECT_EQ(runsOf(world, stage.name), 0u) << stage.name;
        }
    }
    EXPECT_TRUE(effect == Effect::Contacts || world.contacts.size() > 20u);
}

TEST_P(EveryEffect, runsOnlyWhileABodyRequiresIt) {
    const Effect effect = GetParam();
    World world = makeSceneWithout(effect);
    run(world, 2);
    ASSERT_TRUE(addDistantObject(world, effect))
        << "effect_scenes.hpp has no object that requires this effect; add one to addDistantObject()";
    run(world, 5);
    const std::uint64_t runs = runsOf(world, effect);
    EXPECT_EQ(runs, effect == Effect::Explosion ? 1u : 5u);
    world.manifest.pinnedOff |= Manifest::bit(effect);
    run(world, 5);
    EXPECT_EQ(runsOf(world, effect), runs);
}

TEST_P(EveryEffect, changesNoBitWhenPinnedOnWithoutABodyThatRequiresIt) {
    const Effect effect = GetParam();
    World off = makeSceneWithout(effect), on = makeSceneWithout(effect);
    pinEffectOn(on, effect);
    for (int i = 0; i < 150; ++i) {
        step(off, kTick);
        step(on, kTick);
        ASSERT_TRUE(samePile(off, on)) << "after step " << i;
    }
    EXPECT_EQ(runsOf(off, effect), 0u);
    EXPECT_GT(runsOf(on, effect), 0u);
}

TEST_P(EveryEffect, changesNoBitWhenOnlyABodyFarAwayRequiresIt) {
    const Effect effect = GetParam();
    World off = makeSceneWithout(effect), on = makeSceneWithout(effect);
    ASSERT_TRUE(addDistantObject(on, effect))
        << "effect_scenes.hpp has no object that requires this effect; add one to addDistantObject()";
    for (int i = 0; i < 150; ++i) {
        step(off, kTick);
        step(on, kTick);
        ASSERT_TRUE(samePile(off, on)) << "after step " << i;
    }
    EXPECT_GT(runsOf(on, effect), 0u);
}

INSTANTIATE_TEST_SUITE_P(All, EveryEffect, testing::ValuesIn(allEffects()),
                         [](const auto& tested) { return std::string{nameOf(tested.param)}; });

TEST(Effects, noBodyIsPushedOnceContactsArePinnedOff) {
    World world = makeSceneWithout(Effect::Wind);
    run(world, 60);
    ASSERT_GT(world.contacts.size(), 20u);
    const double before = world.bodies.pose[1].centre.y;
    world.manifest.pinnedOff |= Manifest::bit(Effect::Contacts);
    run(world, 60);
    // y points down: the body falls through the floor
    EXPECT_GT(world.bodies.pose[1].centre.y, before + 4.0);
}

}  // namespace
}  // namespace plumb::physics
