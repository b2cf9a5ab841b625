#include <algorithm>

#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

struct Sleepy : Playground {
    Sleepy() { world.settings.sleeping = true; }
};

TEST(Sleep, aStackFallsAsleepAndNothingIsAwake) {
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

TEST(Sleep, endsWhenItIsDisabled) {
    Sleepy scene;
    scene.floor();
    const BodyId crate = scene.crate({0.0, 0.5});
    scene.run(120);
    ASSERT_FALSE(isAwake(scene.world, crate));
    scene.world.settings.sleeping = false;
    scene.run(1);
    EXPECT_TRUE(isAwake(scene.world, crate));
}

TEST(Sleep, aHitWakesOnlyTheIslandOfTheSleepingBody) {
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

TEST(Sleep, bodiesFallWhenTheBodyBelowIsDestroyed) {
    Sleepy scene;
    scene.floor();
    const BodyId below = scene.crate({0.0, 0.5}), above = scene.crate({0.0, 1.5});
    scene.run(120);
    ASSERT_FALSE(isAwake(scene.world, above));
    destroyBody(scene.world, below);
    scene.run(120);
    EXPECT_NEAR(scene.y(above), 0.5, 0.01);
}

TEST(Sleep, bodiesFallWhenTheirFloorIsDestroyed) {
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

TEST(Sleep, changedMassAndFixedRotationWakeABodyOnce) {
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

TEST(Sleep, aPlatformThatStartsToMoveWakesBodiesOnItAndHangingFromIt) {
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
    EXPECT_NEAR(scene.y(lying), 2.75, 0.02) << "the body slept although its platform moves";
    EXPECT_NEAR(scene.y(hanging), 0.0, 0.02);
}

TEST(Sleep, aSlowLiftLeavesNoBodyInTheAir) {
    Sleepy scene;
    const BodyId lift = scene.body(BodyKind::Kinematic, {0.0, 0.0});
    scene.shape(lift, box({2.0f, 0.25f}));
    const BodyId crate = scene.crate({0.0, 0.75});
    ASSERT_TRUE(setVelocity(scene.world, lift, {0.0f, -0.02f}).ok());  // below the sleep speed
    scene.run(600);
    EXPECT_NEAR(scene.y(crate), 0.55, 0.01);
}

/// A crate asleep on a floor, and a kinematic body of a random shape that approaches it at a given speed.
struct Sweeper {
    Sleepy scene;
    BodyId crate;
    BodyId sweeper;
    float speed;

    Sweeper(BroadPhaseKind kind, int shape, float metersPerSecond) : speed{metersPerSecond} {
        scene.world.settings.broadPhase = kind;
        crate = scene.sleeper();
        // The gap is the path of 0.1 s, at least 1 cm; at 20 m/s the sweeper moves 0.33 m per step.
        const double gap = std::max(0.1 * static_cast<double>(speed), 0.01);
        sweeper = scene.body(BodyKind::Kinematic, {-1.0 - gap, 0.5});
        switch (shape) {
            case 0: scene.shape(sweeper, box({0.5f, 0.4f})); break;
            case 1: scene.shape(sweeper, circle(0.5f)); break;
            case 2: scene.shape(sweeper, capsule({0.0f, -0.1f}, {0.0f, 0.1f}, 0.5f)); break;
            default: {
                const std::array<Vec2, 3> corners{Vec2{-0.5f, -0.4f}, Vec2{0.5f, 0.0f}, Vec2{-0.5f, 0.4f}};
                EXPECT_TRUE(createPolygon(scene.world, sweeper, corners).ok());
            }
        }
    }

    void tick(bool byTarget) {
        const WorldPosition next{positionOf(scene.world, sweeper).x + static_cast<double>(speed * kTick),
                                 0.5};
        if (byTarget) (void)moveTo(scene.world, sweeper, next, 0.0f, kTick);
        scene.run(1);
    }

    /// Expects that the crate is awake as soon as the sweeper overlaps it by more than a resting contact may,
    /// plus the displacement of one step at this speed.
    void expectWaking(bool byTarget) {
        if (!byTarget) (void)setVelocity(scene.world, sweeper, {speed, 0.0f});
        const double startX = scene.x(crate);
        const double reach = startX - 1.0 - 0.005;  // position at which both touch, minus the slop
        while (!isAwake(scene.world, crate)) {
            tick(byTarget);
            ASSERT_LT(positionOf(scene.world, sweeper).x, reach + 0.011 + static_cast<double>(speed * kTick))
                << "it passes through a sleeping crate";
        }
        while (positionOf(scene.world, sweeper).x < reach + 0.1) tick(byTarget);
        EXPECT_GT(scene.x(crate), startX + 0.09) << "the awake crate must be pushed";
    }
};

TEST(Sleep, aKinematicBodyWakesBodiesThatItHits) {
    for (std::uint32_t kind = 0; kind < static_cast<std::uint32_t>(BroadPhaseKind::Count); ++kind) {
        for (int shape = 0; shape < 4; ++shape) {
            for (const float speed : {0.01f, 0.04f, 0.3f, 1.0f, 5.0f, 20.0f}) {
                for (const bool byTarget : {false, true}) {
                    SCOPED_TRACE(testing::Message() << "broad phase " << kind << ", shape " << shape << ", "
                                                    << speed << " m/s" << (byTarget ? " by moveTo" : ""));
                    Sweeper{static_cast<BroadPhaseKind>(kind), shape, speed}.expectWaking(byTarget);
                }
            }
        }
    }
}

TEST(Sleep, aSlowKinematicBodyWakesABodyWhileOthersFallAsleep) {
    // Contacts of islands that fall asleep are removed from the step. The pair of the sweeper and the
    // sleeping crate, which do not touch yet, must not be removed with them.
    Sweeper sweep{BroadPhaseKind::Tree, 0, 0.04f};
    sweep.scene.crate({20.0, 0.5});
    sweep.expectWaking(false);
}

TEST(Sleep, aKinematicTriggerReportsASleepingBody) {
    Sleepy scene;
    const BodyId crate = scene.sleeper();
    const BodyId sensor = scene.body(BodyKind::Kinematic, {-3.0, 0.8});
    scene.shape(sensor, box({0.5f, 0.5f}), {.isTrigger = true});
    ASSERT_TRUE(setVelocity(scene.world, sensor, {1.0f, 0.0f}).ok());
    int began = 0, ended = 0;
    for (int i = 0; i < 360; ++i) {
        scene.run(1);
        for (const ContactEvent& event : scene.world.events) {
            began += event.phase == ContactPhase::Began ? 1 : 0;
            ended += event.phase == ContactPhase::Ended ? 1 : 0;
        }
    }
    EXPECT_EQ(began, 1);
    EXPECT_EQ(ended, 1);
    EXPECT_FALSE(isAwake(scene.world, crate)) << "an overlap with a trigger must not prevent sleep";
}

TEST(Sleep, aChangeOfGravityWakesEverything) {
    Playground scene;
    const BodyId crate = scene.sleeper();
    scene.world.settings.gravity = {0.0f, 10.0f};
    scene.run(60);
    EXPECT_GT(scene.y(crate), 5.0);
}

TEST(Sleep, aBodyCreatedAsleepSleepsUntilHit) {
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

TEST(Sleep, sleepingBodiesKeepTheirContacts) {
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
