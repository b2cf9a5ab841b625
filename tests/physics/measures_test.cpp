#include "physics/measure/measures.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {
namespace {

constexpr float kTick = 1.0f / 60.0f;

BodyId addBall(World& world, WorldPosition place, BodyKind kind = BodyKind::Dynamic) {
    const auto body = createBody(world, {.kind = kind, .position = place});
    EXPECT_TRUE(createShape(world, *body, circle(0.5f)));
    return *body;
}

TEST(Measures, energyIsThatOfTheFormulas) {
    World world;  // gravity 10 m/s2, y down
    const BodyId ball = addBall(world, {3.0, -4.0});
    ASSERT_TRUE(setMass(world, ball, 2.0f));
    ASSERT_TRUE(setVelocity(world, ball, {3.0f, 4.0f}));
    EXPECT_NEAR(energyOf(world), 0.5 * 2.0 * 25.0 + 2.0 * 10.0 * 4.0, 1e-4);
    ASSERT_TRUE(setAngularVelocity(world, ball, 2.0f));
    const double inertia = static_cast<double>(world.bodies.mass[ball.index].inertia);
    EXPECT_NEAR(energyOf(world), 25.0 + 80.0 + 0.5 * inertia * 4.0, 1e-4);
    ASSERT_TRUE(createField(
        world,
        {.kind = FieldKind::Spring, .place = {3.0, 1.0}, .strength = 8.0f, .length = 2.0f, .a = ball}));
    EXPECT_NEAR(energyOf(world), 105.0 + 2.0 * inertia + 0.5 * 8.0 * 9.0, 1e-4);
    ASSERT_TRUE(createField(
        world, {.kind = FieldKind::Attractor, .linear = true, .place = {0.0, 0.0}, .strength = 3.0f}));
    EXPECT_NEAR(energyOf(world), 141.0 + 2.0 * inertia + 0.5 * 2.0 * 3.0 * 25.0, 1e-3);
}

TEST(Measures, freeFallConservesEnergyAndAnExplicitSpringGainsItByTheFormula) {
    World fall;
    addBall(fall, {0.0, -100.0});
    const double before = energyOf(fall);
    for (int i = 0; i < 120; ++i) step(fall, kTick);
    EXPECT_NEAR(energyOf(fall) / before, 1.0, 1e-5);

    World spring;
    spring.settings.gravity = {};
    spring.settings.integrator = IntegratorKind::ExplicitEuler;
    spring.settings.quality = 0;
    spring.settings.sleeping = false;
    const BodyId ball = addBall(spring, {1.0, 0.0});
    ASSERT_TRUE(setMass(spring, ball, 1.0f));
    ASSERT_TRUE(createField(spring, {.kind = FieldKind::Attractor, .linear = true, .strength = 40.0f}));
    const double started = energyOf(spring);
    for (int i = 0; i < 60; ++i) step(spring, kTick);
    // Each explicit step multiplies the energy by 1 + (omega h)^2.
    const double gain = std::pow(1.0 + 40.0 / 3600.0, 60);
    EXPECT_NEAR(energyOf(spring) / started / gain, 1.0, 1e-3);
}

TEST(Measures, overlapIsTheMaximumAtTheStartOfTheStep) {
    World world;  // a heavy ball on a light one on the ground, a hard case for quality 0
    world.settings.quality = 0;
    world.settings.sleeping = false;
    addBall(world, {0.0, 0.0}, BodyKind::Static);
    const BodyId light = addBall(world, {0.0, -1.0});
    const BodyId heavy = addBall(world, {0.0, -2.0});
    ASSERT_TRUE(setMass(world, light, 1.0f));
    ASSERT_TRUE(setMass(world, heavy, 50.0f));
    EXPECT_EQ(deepestOverlapOf(world), 0.0f) << "no step has found contacts yet";
    for (int i = 0; i < 60; ++i) step(world, kTick);
    const double below = 1.0 + positionOf(world, light).y;
    const double between = 1.0 - (positionOf(world, light).y - positionOf(world, heavy).y);
    const double deepest = std::max(below, between);
    EXPECT_GT(deepest, 1e-3);
    step(world, kTick);
    EXPECT_NEAR(static_cast<double>(deepestOverlapOf(world)), deepest, 1e-5);
}

TEST(Measures, distanceIsThatOfTheFarthestBody) {
    World world;
    addBall(world, {0.0, 0.0});
    const BodyId second = addBall(world, {5.0, 0.0});
    World other = world;
    EXPECT_EQ(largestDistanceOf(world, other), 0.0);
    ASSERT_TRUE(setPosition(other, second, {8.0, 4.0}, 0.0f));
    EXPECT_NEAR(largestDistanceOf(world, other), 5.0, 1e-12);
    addBall(other, {100.0, 0.0});
    EXPECT_NEAR(largestDistanceOf(world, other), 5.0, 1e-12)
        << "bodies that exist in only one of the worlds are not compared";
}

}  // namespace
}  // namespace plumb::physics
