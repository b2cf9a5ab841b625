#include <cmath>

#include "core/random.hpp"
#include "physics/model/joints.hpp"
#include "tests/physics/support/effect_worlds.hpp"

namespace plumb::physics {
namespace {

using namespace test;

// ---- One-way shapes

BodyId addLedge(World& world) {
    ShapeDefinition shape;
    shape.oneWay = true;
    return addBody(world, BodyKind::Static, {0.0, 0.1}, box({5.0f, 0.1f}), shape);  // its top is at y = 0
}

TEST(OneWay, carriesBodiesThatFallOnIt) {
    World world = makeWorld();
    addLedge(world);
    const BodyId box1 = addBody(world, BodyKind::Dynamic, {0.0, -3.0}, box({0.5f, 0.5f}));
    run(world, 180);
    EXPECT_NEAR(heightOf(world, box1), 0.5, 0.01);
}

TEST(OneWay, letsBodiesPassFromBelowAndCatchesThemFromAbove) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world = makeWorld();
        addLedge(world);
        BodyDefinition body;
        body.velocity = {random.between(-1.0f, 1.0f), random.between(-14.0f, -10.0f)};
        body.angle = random.between(-0.7f, 0.7f);
        const bool round = seed % 2 == 0;
        const BodyId thrown = addBody(world, BodyKind::Dynamic, {0.0, random.between(1.5f, 2.0f)},
                                      round ? circle(0.4f) : box({0.4f, 0.4f}), {}, body);
        double highest = -10.0;
        const double start = heightOf(world, thrown), rise = body.velocity.y * body.velocity.y / 20.0f;
        for (int i = 0; i < 300; ++i) {
            step(world, kStep);
            highest = std::max(highest, heightOf(world, thrown));
        }
        EXPECT_NEAR(highest, start + rise, 0.02 * rise);  // the ledge does not slow the body
        EXPECT_NEAR(heightOf(world, thrown), 0.4, 0.02);
    }
}

TEST(OneWay, letsBodiesFallThatStartInside) {
    World world = makeWorld();
    addLedge(world);
    const BodyId stuck = addBody(world, BodyKind::Dynamic, {0.0, -0.2}, box({0.5f, 0.5f}));
    run(world, 60);
    EXPECT_NEAR(heightOf(world, stuck), 0.2 - 5.0, 0.2);
}

TEST(OneWay, stopsFastBodiesThatComeFromAbove) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world = makeWorld();
        addLedge(world);
        BodyDefinition body;
        body.velocity = {random.between(-3.0f, 3.0f), random.between(5.0f, 25.0f)};
        const BodyId thrown = addBody(world, BodyKind::Dynamic, {0.0, random.between(-4.0f, -2.0f)},
                                      box({0.5f, 0.5f}), {}, body);
        run(world, 60);
        EXPECT_GT(heightOf(world, thrown), 0.4);
    }
}

TEST(OneWay, dropsABodyOnRequestAndReportsTheEnd) {
    World world = makeWorld();
    addLedge(world);
    const BodyId box1 = addBody(world, BodyKind::Dynamic, {0.0, -0.5}, box({0.5f, 0.5f}));
    run(world, 30);
    setDropThrough(world, box1, true);
    step(world, kStep);
    ASSERT_EQ(world.events.size(), 1u);
    EXPECT_EQ(world.events[0].phase, ContactPhase::Ended);
    run(world, 4);
    setDropThrough(world, box1, false);  // the body is halfway through the ledge and falls on
    for (int i = 0; i < 60; ++i) {
        step(world, kStep);
        EXPECT_TRUE(world.events.empty());
    }
    EXPECT_LT(heightOf(world, box1), -3.0);
}

TEST(OneWay, rotatesWithItsBody) {
    World world = makeWorld();
    const BodyId ledge = addLedge(world);
    ASSERT_TRUE(setPosition(world, ledge, {0.0, 0.1}, kPi).ok());  // the ledge now stops bodies from below
    const BodyId box1 = addBody(world, BodyKind::Dynamic, {0.0, -2.0}, box({0.5f, 0.5f}));
    run(world, 90);
    EXPECT_LT(heightOf(world, box1), -3.0);
}

// ---- Conveyors

TEST(Conveyor, carriesAtItsSurfaceSpeed) {
    ShapeDefinition belt;
    belt.surfaceSpeed = 2.0f;
    World world = makeWorld();
    addFloor(world, belt);
    const BodyId box1 = addBody(world, BodyKind::Dynamic, {0.0, -0.5}, box({0.5f, 0.5f}));
    run(world, 120);
    EXPECT_NEAR(velocityOf(world, box1).x, 2.0f, 1e-3f);
    EXPECT_NEAR(velocityOf(world, box1).y, 0.0f, 1e-3f);
}

TEST(Conveyor, speedsUpByFriction) {
    ShapeDefinition belt;
    belt.surfaceSpeed = 50.0f;
    belt.friction = 0.25f;
    ShapeDefinition load;
    load.friction = 1.0f;
    World world = makeWorld();
    addFloor(world, belt);
    const BodyId box1 = addBody(world, BodyKind::Dynamic, {0.0, -0.2}, box({2.0f, 0.2f}), load);
    run(world, 60);
    EXPECT_NEAR(velocityOf(world, box1).x, 0.5f * 10.0f * 1.0f, 0.15f);  // mu g t, mu = sqrt(0.25 * 1)
}

// ---- Rolling resistance

TEST(Rolling, stopsADiscAfterTheDistanceOfTheFormula) {
    constexpr float kSpeed = 2.0f, kRadius = 0.5f, kResistance = 0.1f;
    ShapeDefinition tyre;
    tyre.rollingResistance = kResistance;
    tyre.friction = 1.0f;
    BodyDefinition rolling;
    rolling.velocity = {kSpeed, 0.0f};
    // y points down: rolling forward is clockwise, which is positive
    rolling.angularVelocity = kSpeed / kRadius;
    World world = makeWorld();
    addFloor(world);
    const BodyId disc = addBody(world, BodyKind::Dynamic, {0.0, -0.5}, circle(kRadius), tyre, rolling);
    run(world, 400);
    // With k the resistance divided by the radius: m a r + I a / r = k m g r with I = m r2 / 2, so a = 2/3 k
    // g.
    const float deceleration = 2.0f / 3.0f * kResistance * 10.0f;
    EXPECT_NEAR(positionOf(world, disc).x, kSpeed * kSpeed / (2.0f * deceleration), 0.03);
    EXPECT_NEAR(angularVelocityOf(world, disc), 0.0f, 1e-3f);
}

TEST(Rolling, withoutItADiscRollsOn) {
    BodyDefinition rolling;
    rolling.velocity = {2.0f, 0.0f};
    rolling.angularVelocity = 4.0f;
    World world = makeWorld();
    addFloor(world);
    const BodyId disc = addBody(world, BodyKind::Dynamic, {0.0, -0.5}, circle(0.5f), {}, rolling);
    run(world, 600);
    EXPECT_NEAR(velocityOf(world, disc).x, 2.0f, 0.01f);
}

TEST(Rolling, slowsADiscOnAnotherBody) {
    ShapeDefinition tyre;
    tyre.rollingResistance = 0.2f;
    World world = makeWorld();
    addFloor(world);
    addBody(world, BodyKind::Dynamic, {0.0, -0.5}, box({8.0f, 0.5f}));
    BodyDefinition rolling;
    rolling.velocity = {1.0f, 0.0f};
    rolling.angularVelocity = 2.0f;
    const BodyId disc = addBody(world, BodyKind::Dynamic, {-4.0, -1.5}, circle(0.5f), tyre, rolling);
    run(world, 240);
    EXPECT_NEAR(velocityOf(world, disc).x, 0.0f, 1e-3f);
    EXPECT_NEAR(positionOf(world, disc).x, -4.0 + 1.0 / (2.0 * 2.0 / 3.0 * 0.2 * 10.0), 0.05);
}

// ---- Locked axes

TEST(Locks, keepABodyOnItsAxisUnderAnyForce) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world = makeWorld();
        addFloor(world);
        BodyDefinition body;
        (seed % 2 == 0 ? body.lockX : body.lockY) = true;
        body.velocity = {random.between(-5.0f, 5.0f), random.between(-5.0f, 5.0f)};
        const BodyId held = addBody(world, BodyKind::Dynamic, {0.25, -3.5}, box({0.5f, 0.5f}), {}, body);
        for (int i = 0; i < 10; ++i) {
            addBody(world, BodyKind::Dynamic, {random.between(-2.0f, 2.0f), -5.0 - i}, circle(0.4f));
        }
        run(world, 120);
        if (seed % 2 == 0) {
            EXPECT_EQ(positionOf(world, held).x, 0.25);
        } else {
            EXPECT_EQ(positionOf(world, held).y, -3.5);
        }
    }
}

// ---- Callbacks of StepOptions

struct Say {
    ShapeId refused;
    int asked = 0;
    static bool filter(void* context, const World&, ShapeId a, ShapeId b) {
        const Say& say = *static_cast<Say*>(context);
        return a != say.refused && b != say.refused;
    }
    static bool preSolve(void* context, const World&, const Contact&) {
        ++static_cast<Say*>(context)->asked;
        return false;
    }
};

TEST(ContactHooks, aFilteredPairNeverCollides) {
    World world = makeWorld();
    addFloor(world);
    const BodyId ghost = *createBody(world, {.position = {0.0, -2.0}});
    Say say{*createShape(world, ghost, circle(0.5f))};
    const BodyId solid = addBody(world, BodyKind::Dynamic, {5.0, -2.0}, circle(0.5f));
    StepOptions options;
    options.hooks = {&say, &Say::filter, nullptr};
    for (int i = 0; i < 120; ++i) step(world, kStep, options);
    EXPECT_LT(heightOf(world, ghost), -3.0);
    EXPECT_NEAR(heightOf(world, solid), 0.5, 0.01);
}

TEST(ContactHooks, aContactDisabledBeforeSolvingDoesNotPush) {
    World world = makeWorld();
    addFloor(world);
    const BodyId body = addBody(world, BodyKind::Dynamic, {0.0, -0.6}, circle(0.5f));
    Say say;
    StepOptions options;
    options.hooks = {&say, nullptr, &Say::preSolve};
    for (int i = 0; i < 60; ++i) step(world, kStep, options);
    EXPECT_LT(heightOf(world, body), -2.0);
    EXPECT_GT(say.asked, 10);
    EXPECT_EQ(runsOf(world, "filter contacts"), 60u);
}

// ---- Effects that no object requires

World makePile() {
    World world = makeWorld();
    addFloor(world);
    for (int i = 0; i < 30; ++i) {
        const WorldPosition place{-3.0 + 0.7 * (i % 7), -0.6 - 0.9 * static_cast<double>(i / 7)};
        addBody(world, BodyKind::Dynamic, place, i % 2 == 0 ? box({0.3f, 0.4f}) : circle(0.35f));
    }
    return world;
}

TEST(Effects, aStageThatNothingRequiresIsNotRun) {
    World world = makePile();
    run(world, 10);
    EXPECT_EQ(runsOf(world, "filter contacts"), 0u);
    EXPECT_EQ(runsOf(world, "solve"), 10u);
    EXPECT_EQ(runsOf(world, "no such stage"), 0u);
    run(world, 50);
    ASSERT_FALSE(world.contacts.empty());
    for (const char* unused :
         {"new joints", "explosions", "prepare fields", "soft bodies", "fields", "integrators"})
        EXPECT_EQ(runsOf(world, unused), 0u) << unused;
    ShapeDefinition oneWay;
    oneWay.oneWay = true;
    const BodyId ledge = addBody(world, BodyKind::Static, {50.0, 0.0}, box({1.0f, 0.1f}), oneWay);
    run(world, 10);
    EXPECT_EQ(runsOf(world, "filter contacts"), 10u);
    destroyBody(world, ledge);
    run(world, 10);
    EXPECT_EQ(runsOf(world, "filter contacts"), 10u);
}

class UnusedEffect : public testing::TestWithParam<Effect> {};

TEST_P(UnusedEffect, leavesEveryBitAsItIs) {
    World off = makePile(), on = makePile();
    on.manifest.pinnedOn |= Manifest::bit(GetParam());
    ASSERT_FALSE(off.manifest.runs(GetParam()));
    ASSERT_TRUE(on.manifest.runs(GetParam()));
    for (int i = 0; i < 120; ++i) {
        step(off, kStep);
        step(on, kStep);
        ASSERT_TRUE(sameState(off, on)) << "after step " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Optional, UnusedEffect,
                         testing::Values(Effect::Restitution, Effect::Rolling, Effect::Drag, Effect::Triggers,
                                         Effect::OneWay, Effect::Conveyor, Effect::Kinematics, Effect::Locks,
                                         Effect::AreaGravity, Effect::Wind, Effect::Buoyancy,
                                         Effect::Attractor, Effect::Explosion, Effect::Springs,
                                         Effect::SoftBodies),
                         [](const auto& tested) { return std::string{nameOf(tested.param)}; });

}  // namespace
}  // namespace plumb::physics
