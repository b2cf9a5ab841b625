#include <algorithm>

#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

/// Numbers of contact events in each phase while a scene runs.
struct Counted {
    int began = 0;
    int stayed = 0;
    int ended = 0;

    void add(const World& world) {
        for (const ContactEvent& event : world.events) {
            ++(event.phase == ContactPhase::Began   ? began
               : event.phase == ContactPhase::Ended ? ended
                                                    : stayed);
        }
    }
};

/// Counts the events of two seconds.
Counted countEvents(Playground& scene) {
    Counted events;
    for (int i = 0; i < 120; ++i) scene.run(1), events.add(scene.world);
    return events;
}

/// Adds a trigger of 1 m width.
BodyId addZone(Playground& scene, BodyKind kind, WorldPosition place = {0.0, 0.0}, float height = 10.0f) {
    const BodyId zone = scene.body(kind, place);
    scene.shape(zone, box({0.5f, 0.5f * height}), {.isTrigger = true});
    return zone;
}

TEST(Events, aBodyPutToSleepAtAHitReportsOneBeginEvent) {
    Playground scene;
    scene.world.settings.sleeping = true;
    scene.floor();
    const BodyId lower = scene.crate({0.0, 1.0});
    scene.crate({0.0, 6.0});
    Counted events;
    const auto runWhile = [&](bool awake) {
        int ticks = 0;
        do scene.run(1), events.add(scene.world);
        while (isAwake(scene.world, lower) == awake && scene.world.events.empty() && ++ticks < 120);
        return ticks;
    };
    EXPECT_GT(runWhile(true), 10);  // ticks until the crate reaches the floor
    setAwake(scene.world, lower, false);
    EXPECT_GT(runWhile(false), 10);  // ticks until the upper crate falls on the lower one
    EXPECT_TRUE(isAwake(scene.world, lower));
    EXPECT_EQ(events.began, 2);
    EXPECT_EQ(events.ended, 0);
}

TEST(Events, aFallingCrateBeginsOneContactThatStays) {
    Playground scene;
    scene.world.settings.stayEvents = true;
    scene.floor();
    scene.crate({0.0, 1.5});
    const Counted events = countEvents(scene);
    EXPECT_EQ(events.began, 1);
    EXPECT_EQ(events.ended, 0);
    EXPECT_GT(events.stayed, 60);
}

/// Sum of the impulses of all events of a step, N s.
float impulseOf(const World& world) {
    float sum = 0.0f;
    for (const ContactEvent& event : world.events) sum += event.impulse;
    return sum;
}

TEST(Events, theImpulseOfAnImpactIsCompleteAtEveryQuality) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Playground scene;
        scene.world.settings.gravity = {};
        scene.world.settings.quality = static_cast<Quality>(seed % 5);
        scene.world.settings.continuous = random.below(4) != 0;
        const float bounciness = random.below(3) == 0 ? 0.0f : random.between(0.1f, 1.0f);
        scene.floor({.friction = seed % 2 == 0 ? 0.0f : 0.6f});
        // Fixed rotation selects the reduced kernels.
        const float speed = random.between(1.5f, 40.0f);
        const BodyId body = *createBody(scene.world, {.position = {0.0, 0.6 + random.unit()},
                                                      .velocity = {0.0f, -speed},
                                                      .fixedRotation = random.below(2) == 0,
                                                      .bullet = random.below(4) == 0});
        const bool isBall = random.below(2) == 0;
        const ShapeDefinition definition{.density = random.between(0.1f, 10.0f), .bounciness = bounciness};
        scene.shape(body, isBall ? circle(0.5f) : box({0.5f, 0.5f}), definition);
        const Vec2 before = scene.velocity(body);
        while (scene.world.events.empty()) scene.run(1);
        ASSERT_EQ(scene.world.events.size(), 1u);
        EXPECT_EQ(scene.world.events[0].phase, ContactPhase::Began);
        const float change = massOf(scene.world, body) * (scene.velocity(body).y - before.y);
        EXPECT_NEAR(scene.world.events[0].impulse, change, 1.0e-3f * change);
        EXPECT_GT(scene.world.events[0].impulse,
                  (1.0f + bounciness) * massOf(scene.world, body) * speed * 0.98f);
    }
}

TEST(Events, theImpulseUnderARestingBodyIsItsWeightAtEveryQuality) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Playground scene;
        scene.world.settings.stayEvents = true;
        scene.world.settings.quality = static_cast<Quality>(seed % 5);
        // Several shapes with the same surface id report one event.
        const BodyId ground = scene.body(BodyKind::Static, {0.0, -1.0});
        const float width = random.between(0.4f, 3.0f);
        for (int i = -4; i < 4; ++i)
            scene.shape(ground, box({0.5f * width, 1.0f}, {width * static_cast<float>(i), 0.0f}),
                        {.surface = seed % 2 == 0 ? 7u : 0u});
        const BodyId crate =
            *createBody(scene.world, {.position = {0.0, 0.5}, .fixedRotation = random.below(2) == 0});
        scene.shape(crate, box({0.7f, 0.5f}), {.density = random.between(0.1f, 10.0f)});
        scene.run(240);
        const float weight = 10.0f * massOf(scene.world, crate) * kTick;
        EXPECT_NEAR(impulseOf(scene.world), weight, 2.0e-3f * weight);
        if (seed % 2 == 0) {
            EXPECT_EQ(scene.world.events.size(), 1u);
        }
    }
}

TEST(Events, theImpulsesOfAnImpactChainAreComplete) {
    // The impact propagates through a row of balls within one step: each ball receives the impulse and passes
    // it on.
    Playground scene;
    scene.world.settings.gravity = {};
    std::vector<BodyId> row;
    for (int i = 0; i < 5; ++i) row.push_back(scene.ball({1.0 * i, 0.0}, 0.5f, {.bounciness = 1.0f}));
    const BodyId cue = scene.ball({-3.05, 0.0}, 0.5f, {.bounciness = 1.0f});
    ASSERT_TRUE(setVelocity(scene.world, cue, {6.0f, 0.0f}).ok());
    const float whole = 6.0f * massOf(scene.world, cue);
    scene.world.settings.stayEvents = true;
    float largest = 0.0f;
    for (int i = 0; i < 60; ++i) {
        scene.run(1);
        for (const ContactEvent& event : scene.world.events) largest = std::max(largest, event.impulse);
    }
    EXPECT_GT(scene.velocity(row.back()).x, 5.9f);
    EXPECT_NEAR(largest, whole, 0.02f * whole);
}

TEST(Events, aTriggerReportsBodiesThatEnterAndLeaveAndStopsNone) {
    Playground scene;
    const BodyId door = scene.body(BodyKind::Static, {0.0, 0.0});
    scene.shape(door, box({1.0f, 1.0f}), {.isTrigger = true});
    const BodyId ball = scene.ball({0.0, 5.0});
    Counted events;
    for (int i = 0; i < 120; ++i) {
        scene.run(1);
        for (const ContactEvent& event : scene.world.events) EXPECT_TRUE(event.isTrigger);
        events.add(scene.world);
    }
    EXPECT_EQ(events.began, 1);
    EXPECT_EQ(events.ended, 1);
    EXPECT_NEAR(scene.y(ball), 5.0 - 0.5 * 10.0 * 4.0, 1.0e-3);
}

TEST(Events, twoTriggersReportEachOther) {
    Playground scene;
    scene.world.settings.gravity = {};
    const BodyId a = scene.ball({0.0, 0.0}, 0.5f, {.isTrigger = true});
    const BodyId b = scene.ball({3.0, 0.0}, 0.5f, {.isTrigger = true});
    ASSERT_TRUE(setVelocity(scene.world, b, {-3.0f, 0.0f}).ok());
    const Counted events = countEvents(scene);
    EXPECT_EQ(events.began, 1);
    EXPECT_EQ(events.ended, 1);
    EXPECT_EQ(velocityOf(scene.world, a), Vec2{});
}

TEST(Events, aTriggerReportsBoxesThatPassAlongItsNormal) {
    Playground scene;
    scene.world.settings.gravity = {};
    addZone(scene, BodyKind::Static);
    const BodyId crate = scene.crate({-4.0, 0.0});
    ASSERT_TRUE(setVelocity(scene.world, crate, {4.0f, 0.0f}).ok());
    const Counted events = countEvents(scene);
    EXPECT_EQ(events.began, 1);
    EXPECT_EQ(events.ended, 1) << "it left on the other side";
}

TEST(Events, aTriggerReportsStaticAndKinematicBodies) {
    for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic}) {
        for (const bool solid : {true, false}) {
            Playground scene;
            addZone(scene, kind);
            const BodyId platform = scene.body(BodyKind::Kinematic, {-4.0, 0.0});
            scene.shape(platform, box({0.5f, 0.5f}), {.isTrigger = !solid});
            ASSERT_TRUE(setVelocity(scene.world, platform, {4.0f, 0.0f}).ok());
            const Counted events = countEvents(scene);
            EXPECT_EQ(events.began, 1);
            EXPECT_EQ(events.ended, 1);
        }
    }
}

TEST(Events, aStaticTriggerIgnoresStaticBodies) {
    Playground scene;
    scene.floor();
    const BodyId zone = scene.body(BodyKind::Static, {0.0, 0.0});
    scene.shape(zone, box({5.0f, 5.0f}), {.isTrigger = true});
    scene.run(10);
    EXPECT_TRUE(scene.world.contacts.empty());
}

TEST(Events, aMovingTriggerDoesNotWakeSleepingBodies) {
    Playground scene;
    scene.sleeper();
    const BodyId zone = addZone(scene, BodyKind::Kinematic, {-4.0, 0.5}, 0.5f);
    ASSERT_TRUE(setVelocity(scene.world, zone, {4.0f, 0.0f}).ok());
    const Counted events = countEvents(scene);
    EXPECT_EQ(events.began, 1);
    EXPECT_EQ(events.ended, 1);
    EXPECT_EQ(scene.world.awake.size(), 1u) << "no body was woken";
}

TEST(Events, aTriggerEndsContactsWithSleepingBodiesInAnyOrderOfCreation) {
    for (const bool zoneFirst : {true, false}) {
        SCOPED_TRACE(zoneFirst);
        Playground scene;
        BodyId zone{};
        const auto add = [&] { zone = addZone(scene, BodyKind::Kinematic, {0.0, 0.5}, 0.5f); };
        if (zoneFirst) add();
        scene.world.settings.sleeping = true;
        scene.floor();
        const BodyId crate = scene.crate({0.0, 0.5});
        if (!zoneFirst) add();
        scene.run(60);
        ASSERT_FALSE(isAwake(scene.world, crate)) << "an overlap with a trigger must not keep a body awake";
        ASSERT_TRUE(setVelocity(scene.world, zone, {4.0f, 0.0f}).ok());
        const Counted events = countEvents(scene);
        EXPECT_EQ(events.ended, 1);
        EXPECT_FALSE(isAwake(scene.world, crate));
    }
}

TEST(Events, destroyingABodyEndsItsContacts) {
    Playground scene;
    scene.floor();
    const BodyId crate = scene.crate({0.0, 0.5});
    scene.run(10);
    ASSERT_EQ(touching(scene.world), 1);
    destroyBody(scene.world, crate);
    scene.run(1);
    ASSERT_EQ(scene.world.events.size(), 1u);
    EXPECT_EQ(scene.world.events[0].phase, ContactPhase::Ended);
    EXPECT_TRUE(scene.world.events[0].b == crate || scene.world.events[0].a == crate);
    EXPECT_FALSE(alive(scene.world, crate));
}

TEST(Events, masksAndGroupsDecideWhichShapesCollide) {
    Playground scene;
    scene.floor({.layers = 1});
    const BodyId ghost = scene.ball({0.0, 2.0}, 0.5f, {.layers = 2, .mask = 4});
    const BodyId solid = scene.ball({3.0, 2.0}, 0.5f, {.layers = 4});
    const BodyId one = scene.ball({6.0, 2.0}, 0.5f, {.group = -3}),
                 two = scene.ball({6.4, 3.0}, 0.5f, {.group = -3});
    scene.run(120);
    EXPECT_LT(scene.y(ghost), -5.0);
    EXPECT_NEAR(scene.y(solid), 0.5, 0.01);
    EXPECT_NEAR(scene.y(one), 0.5, 0.01);
    EXPECT_NEAR(scene.y(two), 0.5, 0.01);
}

TEST(Events, aChangedFilterEndsContacts) {
    Playground scene;
    const BodyId crate = scene.sleeper();
    const std::uint32_t shape = scene.world.bodies.info[crate.index].firstShape;
    setFilter(scene.world, {shape, scene.world.shapes.info[shape].generation}, 1, 2, 0);
    scene.run(1);
    ASSERT_EQ(scene.world.events.size(), 1u);
    EXPECT_EQ(scene.world.events[0].phase, ContactPhase::Ended);
    scene.run(60);
    EXPECT_LT(scene.y(crate), -1.0);
}

}  // namespace
}  // namespace plumb::physics
