#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Exact limits for rest and sleep, and the maximum speed of bodies.

using namespace plumb;
using namespace plumb::physics;

namespace {

/// Number of steps until a freely drifting body sleeps; -1 if it does not within three seconds.
int stepsToSleep(float speed, float spin, float sleepSpeed, float sleepTime, float dt = kTick) {
    World world;
    world.settings.gravity = {};
    world.settings.sleepTime = sleepTime;
    const BodyId body = *createBody(
        world,
        {.velocity = {0.6f * speed, -0.8f * speed}, .angularVelocity = spin, .sleepSpeed = sleepSpeed});
    static_cast<void>(createShape(world, body, circle(0.5f, {1.5f, 0.0f}), {}));
    // The mass is centered at the origin, so the disc's farthest point is 2 m from the center of mass.
    static_cast<void>(setMassData(world, body, {1.0f, {}, 1.0f}));
    for (int i = 1; i < static_cast<int>(3.0f / dt); ++i) {
        step(world, dt);
        if (!isAwake(world, body)) return i;
    }
    return -1;
}

}  // namespace

TEST(SleepLimits, bodiesBelowTheSleepSpeedSleepExactlyAfterTheSleepTime) {
    for (const float limit : {0.05f, 0.4f}) {
        EXPECT_EQ(stepsToSleep(0.99f * limit, 0.0f, limit, 0.495f), 30);
        EXPECT_EQ(stepsToSleep(1.01f * limit, 0.0f, limit, 0.495f), -1);
        // The farthest point is 2 m from the center of mass, so its speed is twice the angular velocity.
        EXPECT_EQ(stepsToSleep(0.0f, 0.49f * limit, limit, 0.495f), 30);
        EXPECT_EQ(stepsToSleep(0.0f, -0.49f * limit, limit, 0.495f), 30);
        EXPECT_EQ(stepsToSleep(0.0f, 0.51f * limit, limit, 0.495f), -1);
        EXPECT_EQ(stepsToSleep(0.0f, -0.51f * limit, limit, 0.495f), -1);
    }
    EXPECT_EQ(stepsToSleep(0.0f, 0.0f, 0.0f, 0.495f), 30) << "a speed of 0 does not exceed a limit of 0";
    EXPECT_EQ(stepsToSleep(1.0e-4f, 0.0f, 0.0f, 0.495f), -1);
    EXPECT_EQ(stepsToSleep(0.25f, 0.0f, 0.25f, 0.495f), 30) << "the sleep speed itself counts as rest";
    EXPECT_EQ(stepsToSleep(0.0f, 0.0f, 0.05f, 1.5f, 0.125f), 12) << "sleeps exactly after the sleep time";
    EXPECT_EQ(stepsToSleep(0.0f, 0.0f, 0.05f, 0.0f), 1);
}

TEST(SleepLimits, anIslandSleepsWithTheMostRestlessOfItsBodies) {
    World world;
    world.settings.gravity = {};
    world.settings.sleepTime = 0.495f;
    const BodyId a = addBody(world, BodyKind::Dynamic, {}), b = addBody(world, BodyKind::Dynamic, {3.0, 0.0}),
                 alone = addBody(world, BodyKind::Dynamic, {9.0, 0.0});
    for (const BodyId body : {a, b, alone}) static_cast<void>(createShape(world, body, circle(0.5f)));
    ASSERT_TRUE(createJoint(world, {.kind = JointKind::Distance, .a = a, .b = b, .length = 3.0f}));
    for (int i = 1; i <= 60; ++i) {
        if (i <= 20) setAwake(world, b, true);
        step(world, kTick);
        EXPECT_EQ(isAwake(world, alone), i < 30) << i;
        EXPECT_EQ(isAwake(world, a), isAwake(world, b)) << i;
        EXPECT_EQ(isAwake(world, a), i < 49) << i;  // b is slow enough from step 20 on
    }
}

TEST(SleepLimits, oscillatingBodiesSleepByTheirMeanEnergy) {
    // For a sine the time below the limit outweighs the energy above it up to an amplitude of 1.5 limits.
    for (const auto& [amplitude, sleeps] : {std::pair{1.2f, true}, {2.0f, false}}) {
        World world;
        world.settings.gravity = {};
        const BodyId body = addBody(world, BodyKind::Dynamic, {});
        static_cast<void>(createShape(world, body, circle(0.5f)));
        FieldDefinition spring;
        spring.kind = FieldKind::Spring;
        spring.a = body;
        spring.place = {0.0, 3.0};
        spring.length = 3.0f;
        const float frequency = 30.0f;  // rad/s
        spring.strength = massOf(world, body) * frequency * frequency;
        ASSERT_TRUE(createField(world, spring).ok());
        // Speed limit of bodies that are moved only by fields, m/s.
        const float limit = world.settings.slop / world.settings.sleepTime;
        ASSERT_TRUE(setVelocity(world, body, {0.0f, amplitude * limit}).ok());
        for (int i = 0; i < 600; ++i) step(world, kTick);
        EXPECT_EQ(!isAwake(world, body), sleeps) << amplitude;
    }
}

TEST(SleepLimits, slowlyFallingBodiesDoNotSleepInTheAir) {
    for (const float gravity : {1.0e-3f, 0.02f, 0.09f}) {
        World world;
        world.settings.gravity = {0.0f, gravity};
        const BodyId body = addBody(world, BodyKind::Dynamic, {});
        static_cast<void>(createShape(world, body, circle(0.5f)));
        for (int i = 0; i < 600; ++i) step(world, kTick);
        EXPECT_NEAR(positionOf(world, body).y, 0.5 * static_cast<double>(gravity) * 100.0, 1e-3);
    }
}

TEST(SleepLimits, swayingPyramidsComeToRest) {
    for (const std::uint32_t rows : {12u, 16u, 19u}) {
        for (const Quality quality : {Quality{1}, Quality{2}, Quality{3}}) {
            World world;
            world.settings.quality = quality;
            const BodyId floor = addBody(world, BodyKind::Static, {0.0, 1.0});
            static_cast<void>(createShape(world, floor, box({100.0f, 1.0f})));
            for (std::uint32_t row = 0; row < rows; ++row) {
                for (std::uint32_t i = 0; i < rows - row; ++i) {
                    const BodyId brick =
                        addBody(world, BodyKind::Dynamic, {1.05 * (i + 0.5 * row), -0.5 - 1.0 * row});
                    static_cast<void>(createShape(world, brick, box({0.5f, 0.5f})));
                }
            }
            for (int i = 0; i < 600; ++i) step(world, kTick);
            EXPECT_TRUE(world.awake.empty()) << rows << " rows, quality " << int{quality};
        }
    }
}

TEST(SpeedLimits, fasterBodiesAreClampedAndKeepTheirDirection) {
    for (const float speed : {5.0f, 39.9f, 40.1f, 1000.0f, 1.0e6f}) {
        for (const float spin : {0.0f, 3.0f, -30.0f, 5000.0f, -1.0e6f}) {
            SCOPED_TRACE(testing::Message() << speed << " m/s, " << spin << " rad/s");
            World world;
            world.settings.gravity = {};
            world.settings.maxSpeed = 40.0f;
            const BodyId body =
                *createBody(world, {.velocity = {0.6f * speed, -0.8f * speed}, .angularVelocity = spin});
            static_cast<void>(createShape(world, body, circle(0.5f)));
            step(world, kTick);
            const float wanted = std::min(speed, 40.0f), turns = std::min(std::fabs(spin), 80.0f);
            EXPECT_NEAR(velocityOf(world, body).x, 0.6f * wanted, 1.0e-5f * wanted);
            EXPECT_NEAR(velocityOf(world, body).y, -0.8f * wanted, 1.0e-5f * wanted);
            EXPECT_NEAR(angularVelocityOf(world, body), std::copysign(turns, spin), 1.0e-5f * turns);
            EXPECT_NEAR(length(toVec2(centreOf(world, body))), wanted * kTick, 1.0e-4f * wanted * kTick);
        }
    }
}
