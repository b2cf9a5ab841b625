#include "tests/physics/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

struct Sleepy : Playground {
    Sleepy() { world.settings.sleeping = true; }
};

TEST(Sleep, aStackFallsAsleepAndItsWorldRestsWithIt) {
    Sleepy scene;
    scene.floor();
    BodyId top;
    for (int i = 0; i < 5; ++i) top = scene.crate({0.0, 0.5 + i});
    scene.run(300);
    EXPECT_FALSE(isAwake(scene.world, top));
    EXPECT_TRUE(scene.world.awake.empty());
    EXPECT_TRUE(scene.world.contacts.empty());
    const std::vector<std::uint64_t> before = bitsOf(scene.world);
    scene.run(60);
    EXPECT_EQ(bitsOf(scene.world), before);
}

TEST(Sleep, whatHitsASleeperWakesItsIslandAndNoOther) {
    Sleepy scene;
    scene.floor();
    const BodyId left = scene.crate({0.0, 0.5}), onLeft = scene.crate({0.0, 1.5}),
                 right = scene.crate({10.0, 0.5});
    scene.run(120);
    ASSERT_TRUE(scene.world.awake.empty());
    scene.ball({0.0, 5.0}, 0.3f);
    int ticks = 0;
    while (!isAwake(scene.world, onLeft) && ++ticks < 120) scene.run(1);
    EXPECT_TRUE(isAwake(scene.world, left));
    EXPECT_TRUE(isAwake(scene.world, onLeft));
    EXPECT_FALSE(isAwake(scene.world, right));
}

TEST(Sleep, whatStandsOnSomethingFallsWhenThatGoes) {
    Sleepy scene;
    scene.floor();
    const BodyId below = scene.crate({0.0, 0.5}), above = scene.crate({0.0, 1.5});
    scene.run(120);
    ASSERT_FALSE(isAwake(scene.world, above));
    destroyBody(scene.world, below);
    scene.run(120);
    EXPECT_NEAR(scene.y(above), 0.5, 0.01);
}

TEST(Sleep, whatStandsOnAFloorFallsWhenTheFloorGoes) {
    Sleepy scene;
    const BodyId ground = scene.floor();
    const BodyId crate = scene.crate({0.0, 0.5});
    scene.run(120);
    ASSERT_FALSE(isAwake(scene.world, crate));
    destroyBody(scene.world, ground);
    scene.run(60);
    EXPECT_LT(scene.y(crate), -3.0);
}

TEST(Sleep, setVelocityWakes) {
    Sleepy scene;
    scene.floor();
    const BodyId crate = scene.crate({0.0, 0.5});
    scene.run(120);
    ASSERT_FALSE(isAwake(scene.world, crate));
    ASSERT_TRUE(setVelocity(scene.world, crate, {0.0f, 5.0f}).ok());
    scene.run(10);
    EXPECT_GT(scene.y(crate), 1.0);
}

TEST(Sleep, anotherMassAndLeaveToTurnWakeABodyOnce) {
    Playground scene;
    const BodyId crate = scene.sleeper();
    ASSERT_TRUE(setMass(scene.world, crate, 5.0f).ok());
    EXPECT_TRUE(isAwake(scene.world, crate));
    setAwake(scene.world, crate, false);
    ASSERT_TRUE(setMass(scene.world, crate, 5.0f).ok());
    setFixedRotation(scene.world, crate, false);
    EXPECT_FALSE(isAwake(scene.world, crate)) << "nothing is new";
    setFixedRotation(scene.world, crate, true);
    EXPECT_TRUE(isAwake(scene.world, crate));
}

TEST(Sleep, aPlatformThatStartsToMoveWakesWhatLiesOnItAndWhatHangsFromIt) {
    Sleepy scene;
    const BodyId platform = scene.body(BodyKind::Kinematic, {0.0, 0.0});
    scene.shape(platform, box({2.0f, 0.25f}));
    const BodyId lying = scene.crate({1.0, 0.75});
    const BodyId hanging = scene.ball({0.0, -2.0}, 0.25f);
    ASSERT_TRUE(
        createJoint(scene.world, {.kind = JointKind::Distance, .a = platform, .b = hanging, .length = 2.0f})
            .ok());
    scene.run(180);
    ASSERT_FALSE(isAwake(scene.world, lying));
    ASSERT_FALSE(isAwake(scene.world, hanging));
    ASSERT_TRUE(setVelocity(scene.world, platform, {0.0f, 1.0f}).ok());
    scene.run(60);
    EXPECT_NEAR(scene.y(lying), 1.75, 0.02);
    EXPECT_NEAR(scene.y(hanging), -1.0, 0.02);
    scene.run(60);
    EXPECT_NEAR(scene.y(lying), 2.75, 0.02) << "it fell asleep on a platform that moves";
    EXPECT_NEAR(scene.y(hanging), 0.0, 0.02);
}

TEST(Sleep, aSlowLiftDoesNotLeaveAnybodyInTheAir) {
    Sleepy scene;
    const BodyId lift = scene.body(BodyKind::Kinematic, {0.0, 0.0});
    scene.shape(lift, box({2.0f, 0.25f}));
    const BodyId crate = scene.crate({0.0, 0.75});
    ASSERT_TRUE(setVelocity(scene.world, lift, {0.0f, -0.02f}).ok());  // slower than what counts as rest
    scene.run(600);
    EXPECT_NEAR(scene.y(crate), 0.55, 0.01);
}

TEST(Sleep, aBodyMadeAsleepWaitsToBeHit) {
    Sleepy scene;
    const Result<BodyId> hanging = createBody(scene.world, {.position = {0.0, 5.0}, .awake = false});
    ASSERT_TRUE(hanging.ok());
    scene.shape(*hanging, box({0.5f, 0.5f}));
    scene.run(60);
    EXPECT_EQ(scene.y(*hanging), 5.0);
    scene.ball({0.0, 8.0});
    scene.run(120);
    EXPECT_LT(scene.y(*hanging), 4.0);
}

TEST(Sleep, sleepersKeepTheirContactsAndWakeWithThem) {
    Sleepy scene;
    scene.floor();
    const BodyId low = scene.crate({0.0, 0.5}), high = scene.crate({0.0, 1.5});
    scene.run(200);
    ASSERT_TRUE(scene.world.awake.empty());
    setAwake(scene.world, low, true);
    EXPECT_EQ(touching(scene.world), 2);
    const double before = scene.y(high);
    scene.run(5);
    EXPECT_NEAR(scene.y(high), before, 1.0e-3);
    EXPECT_TRUE(scene.world.events.empty());
}

}  // namespace
}  // namespace plumb::physics
