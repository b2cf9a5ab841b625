#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/task_pool.hpp"
#include "physics/measure/snapshot.hpp"
#include "physics/queries/lists.hpp"
#include "tests/physics/support/edited_worlds.hpp"

// Interfaces between a game and a world: recordings, snapshots, hits, lists of bodies, callbacks.

namespace plumb::physics {
namespace {

TEST(FromOutside, recordingsWithRandomEditsAreReplayedExactly) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        World world = makePit(20, seed);
        Random random = Random::seeded(seed);
        WorldRecording recording{world};
        for (int i = 0; i < 60; ++i) {
            if (i % 5 == 0) applyRandomEdit(world, random);
            recording.step(world, kTick);
        }
        std::vector<std::uint8_t> bytes = recording.toBytes();
        const auto loaded = WorldRecording::from(bytes);
        ASSERT_TRUE(loaded.ok());
        const auto again = loaded->replay(60);
        ASSERT_TRUE(again.ok()) << again.error().text();
        EXPECT_EQ(hashOf(*again), hashOf(world));
        EXPECT_FALSE(loaded->replay(61).ok());
        bytes[bytes.size() / 2] ^= 1;
        EXPECT_FALSE(WorldRecording::from(bytes).ok());
    }
}

TEST(FromOutside, aReplayReportsTheFirstStepThatDiffers) {
    World world = makePit(10, 1);
    WorldRecording recording{world};
    StepOptions options;
    options.hooks.friction = [](void*, const World& now, const Contact&) {
        return now.steps > 30 ? 0.0f : 0.6f;
    };
    for (int i = 0; i < 60; ++i) recording.step(world, kTick, options);
    EXPECT_TRUE(recording.replay(60, options).ok());
    const auto other = recording.replay(60);
    ASSERT_FALSE(other.ok());
    EXPECT_NE(other.error().text().find("step 30"), std::string::npos) << other.error().text();
}

TEST(FromOutside, snapshotsContainTheWholeState) {
    World world = makePit(30, 7);
    run(world, 100);
    const std::vector<std::uint8_t> bytes = toBytes(world);
    Result<World> loaded = worldFrom(bytes);
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(toBytes(*loaded), bytes);
    run(world, 60);
    run(*loaded, 60);
    EXPECT_EQ(hashOf(world), hashOf(*loaded));
    for (std::size_t cut = 0; cut < bytes.size(); cut += 1 + bytes.size() / 50)
        EXPECT_FALSE(worldFrom(std::span{bytes}.first(cut)).ok()) << cut;
}

TEST(FromOutside, callbacksCanSetFrictionAndBouncinessLikeShapes) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        World own = makePit(25, seed), asked = makePit(25, seed);
        for (std::uint32_t s = 0; s < own.shapes.size(); ++s) {
            ASSERT_TRUE(
                change(own, shapeAt(own, s), [](auto& d) { d.friction = d.bounciness = 0.25f; }).ok());
            ASSERT_TRUE(setFriction(asked, shapeAt(asked, s), 0.0f).ok());
        }
        StepOptions options;
        options.hooks.friction = [](void*, const World&, const Contact&) { return 0.25f; };
        options.hooks.bounciness = [](void*, const World&, const Contact&) { return 0.25f; };
        for (int i = 0; i < 90; ++i) {
            step(own, kTick);
            step(asked, kTick, options);
        }
        EXPECT_TRUE(sameBytes(own.bodies.pose, asked.bodies.pose)) << seed;
    }
}

TEST(FromOutside, stepsOnAForeignSchedulerGiveTheSameBits) {
    struct Scheduler {
        int rounds = 0;
        static void run(void* owner, int count, TaskPool::Call task, void* context) {
            ++static_cast<Scheduler*>(owner)->rounds;
            for (int part = count; part-- > 0;) task(context, part, part % 3);  // in reverse order
        }
    } scheduler;
    TaskPool pool{3, Scheduler::run, &scheduler};
    World own = makePit(600, 8), foreign = makePit(600, 8);
    for (int i = 0; i < 30; ++i) {
        step(own, kTick);
        step(foreign, kTick, {.pool = &pool, .minimumWork = 0});
    }
    EXPECT_EQ(hashOf(own), hashOf(foreign));
    EXPECT_GT(scheduler.rounds, 30);
}

TEST(FromOutside, hitsReportTheApproachSpeed) {
    Random random = Random::seeded(9);
    for (int i = 0; i < 30; ++i) {
        const bool bullet = i % 2 == 0;
        const float speed = bullet ? random.between(30.0f, 300.0f) : random.between(2.0f, 10.0f);
        Playground playground;
        playground.world.settings.gravity = {};
        const BodyId wall = playground.body(BodyKind::Kinematic, {5.0, 0.0});
        playground.shape(wall, box({0.5f, 5.0f}));
        ASSERT_TRUE(setVelocity(playground.world, wall, {-1.0f, 0.0f}).ok());
        const BodyId ball = *createBody(playground.world, {.velocity = {speed, 3.0f}, .bullet = bullet});
        playground.shape(ball, circle(0.2f), {.friction = 0.0f, .bounciness = 0.5f});
        float approachSpeed = 0.0f;
        for (int n = 0; n < 200 && approachSpeed == 0.0f; ++n) {
            step(playground.world, kTick);
            for (const ContactEvent& event : playground.world.events) {
                if (event.phase == ContactPhase::Began) approachSpeed = event.approachSpeed;
            }
        }
        EXPECT_NEAR(approachSpeed, speed + 1.0f, 0.001f * speed) << i;
    }
}

TEST(FromOutside, theApproachSpeedIncludesTheRotationOfTheBodies) {
    Random random = Random::seeded(10);
    std::array<int, 2> hits{};
    for (int i = 0; i < 40; ++i) {
        Playground playground;
        World& world = playground.world;
        world.settings.gravity = {};
        const bool plateFirst = i % 2 == 0;
        BodyId plate, ball;
        const auto addPlate = [&] {
            plate = playground.body(i % 4 < 2 ? BodyKind::Kinematic : BodyKind::Dynamic, {});
            playground.shape(plate, box({0.3f, 3.0f}), {.density = 1e4f});
        };
        if (plateFirst) addPlate();
        ball = playground.body(BodyKind::Dynamic, {-2.0, static_cast<double>(random.between(0.5f, 2.0f))});
        playground.shape(ball, circle(0.2f));
        if (!plateFirst) addPlate();
        const float spin = random.between(-1.0f, 1.0f);
        const Vec2 velocity{random.between(4.0f, 8.0f), 0.0f};
        ASSERT_TRUE(setAngularVelocity(world, plate, spin).ok());
        ASSERT_TRUE(setVelocity(world, ball, velocity).ok());
        for (int n = 0; n < 60; ++n) {
            step(world, kTick);
            const auto began =
                std::find_if(world.events.begin(), world.events.end(),
                             [](const ContactEvent& event) { return event.phase == ContactPhase::Began; });
            if (began == world.events.end()) continue;
            // Relative velocity before the hit, at the contact point after the step. In this step the bodies
            // rotate by up to 0.02 rad, so it is inexact.
            const Vec2 speed = velocity - cross(spin, began->point);
            EXPECT_NEAR(began->approachSpeed, std::fabs(dot(began->normal, speed)), 0.05f * length(speed))
                << i;
            ++hits[began->a.index == plate.index ? 0 : 1];
            break;
        }
    }
    EXPECT_GT(hits[0], 5);
    EXPECT_GT(hits[1], 5);
}

TEST(FromOutside, movingBodiesAreListedUntilTheySleep) {
    World world = makePit(30, 6);
    std::vector<BodyId> moved;
    for (int i = 0; i < 400; ++i) {
        const std::vector<BodyPose> before = world.bodies.pose;
        step(world, kTick);
        movedBodies(world, moved);
        std::vector<bool> listed(world.bodies.size());
        for (const BodyId body : moved) listed[body.index] = true;
        for (std::size_t b = 0; b < before.size(); ++b) {
            EXPECT_TRUE(before[b] == world.bodies.pose[b] || listed[b]) << i << " " << b;
        }
    }
}

TEST(FromOutside, shapesAndJointsOfABodyAreListedInOrder) {
    Shelf s;
    const ShapeId second = *createShape(s.world, s.crate, circle(0.1f));
    const JointId rod = *createJoint(s.world, {.kind = JointKind::Distance, .a = s.shelf, .b = s.crate});
    const JointId filter = *createJoint(s.world, {.kind = JointKind::Filter, .a = s.shelf, .b = s.crate});
    std::vector<ShapeId> shapes;
    std::vector<JointId> joints;
    shapesOf(s.world, s.crate, shapes);
    jointsOf(s.world, s.crate, joints);
    ASSERT_EQ(shapes.size(), 2u);
    EXPECT_EQ(shapes[1], second);
    EXPECT_EQ(joints, (std::vector{rod, filter}));
    const AABB bounds = boundsOf(s.world);
    EXPECT_NEAR(bounds.min.x, -1.0f, 0.1f);
    EXPECT_NEAR(boundsOf(s.world, s.crate).max.y, 1.1f, 0.1f);
    EXPECT_EQ(boundsOf(World{}), AABB{});
}

}  // namespace
}  // namespace plumb::physics
