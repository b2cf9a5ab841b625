#include <cmath>

#include "core/random.hpp"
#include "physics/model/fields.hpp"
#include "tests/physics/support/effect_worlds.hpp"

namespace plumb::physics {
namespace {

using namespace test;

/// Sets a random quality, and a random integrator among those that are stable for oscillations.
void chooseScheme(Random& random, World& world) {
    world.settings.quality = static_cast<Quality>(random.below(5));
    world.settings.integrator = static_cast<IntegratorKind>(1 + random.below(3));
}

float powerOfTen(Random& random, float from, float to) { return std::pow(10.0f, random.between(from, to)); }

/// A spring with random strength and damping.
FieldDefinition springOf(Random& random, BodyId body, WorldPosition place, float length) {
    FieldDefinition spring = fieldOf(FieldKind::Spring);
    spring.a = body;
    spring.place = place;
    spring.strength = powerOfTen(random, 0.0f, 9.0f);
    spring.damping = powerOfTen(random, 0.0f, 7.0f);
    spring.length = length;
    return spring;
}

TEST(StiffFields, fluidWindAndSpringsTogetherDoNotEjectBodies) {
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        Random random = Random::seeded(seed);
        World world = makeWorld();
        chooseScheme(random, world);
        SCOPED_TRACE(seed);
        const float radius = powerOfTen(random, -2.0f, 0.0f);
        const BodyId body = addBody(world, BodyKind::Dynamic, {0.0, 0.5}, circle(radius));
        const std::uint32_t springs = 1 + random.below(4);
        for (std::uint32_t i = 0; i < springs; ++i) {
            FieldDefinition spring = springOf(random, body, {0.3 * i, -0.2 * i}, random.between(0.0f, 1.0f));
            if (random.below(2) == 0) spring.anchorA = {0.5f * radius, 0.0f};
            ASSERT_TRUE(createField(world, spring).ok());
        }
        FieldDefinition fluid = fieldOf(FieldKind::Buoyancy);
        fluid.density = powerOfTen(random, 0.0f, 4.5f);
        fluid.linearDrag = fluid.angularDrag = powerOfTen(random, -1.0f, 4.0f);
        ASSERT_TRUE(createField(world, fluid).ok());
        FieldDefinition wind = fieldOf(FieldKind::Wind);
        wind.velocity = {3.0f, 0.0f};
        wind.density = powerOfTen(random, 0.0f, 4.0f);
        ASSERT_TRUE(createField(world, wind).ok());
        double farthest = 0.0;
        for (int i = 0; i < 300; ++i) {
            step(world, kStep);
            farthest =
                std::max(farthest, static_cast<double>(length(positionOf(world, body) - WorldPosition{})));
        }
        // The wind carries the body by at most 15 m, the springs are up to 2 m long.
        EXPECT_LT(farthest, 18.0);
    }
}

TEST(StiffFields, aTetheredBuoyStaysWhereItsSpringBalancesTheFluid) {
    int judged = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Random random = Random::seeded(seed);
        World world = makeWorld();
        chooseScheme(random, world);
        const float radius = powerOfTen(random, -1.0f, 0.0f);
        const BodyId buoy = addBody(world, BodyKind::Dynamic, {0.0, 20.0}, circle(radius));
        FieldDefinition fluid = fieldOf(FieldKind::Buoyancy);
        fluid.density = 1.5f * powerOfTen(random, 0.0f, 3.0f);
        fluid.linearDrag = fluid.angularDrag = random.between(2.0f, 20.0f);
        ASSERT_TRUE(createField(world, fluid).ok());
        FieldDefinition spring = fieldOf(FieldKind::Spring);
        spring.a = buoy;
        spring.place = {0.0, 22.0};
        const float lift =
            (fluid.density - 1.0f) * massOf(world, buoy) * length(world.settings.gravity);  // N
        const float stretch = random.between(0.1f, 2.0f);                                   // m
        spring.strength = lift / stretch;
        spring.length = 1.0f;
        // Springs with (frequency * step)^2 / 2 > 1 are softened by the solver, which changes the
        // equilibrium.
        if (0.5f * spring.strength / (massOf(world, buoy) * 60.0f * 60.0f) > 1.0f) continue;
        ASSERT_TRUE(createField(world, spring).ok());
        SCOPED_TRACE(testing::Message() << seed << " density " << fluid.density << " stretch " << stretch);
        run(world, 1200);
        EXPECT_NEAR(positionOf(world, buoy).y, 21.0 - static_cast<double>(stretch), 0.02 * stretch + 1e-3);
        ++judged;
    }
    EXPECT_GT(judged, 250);
}

TEST(StiffFields, aSpringOnASliderKeepsItsSwing) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Random random = Random::seeded(seed);
        World world = makeWorld();
        chooseScheme(random, world);
        ShapeDefinition smooth;
        smooth.friction = 0.0f;
        addFloor(world, smooth);
        const BodyId slider = addBody(world, BodyKind::Dynamic, {0.0, -0.5}, box({2.0f, 0.5f}), smooth);
        FieldDefinition spring = fieldOf(FieldKind::Spring);
        spring.a = slider;
        spring.place = {10.0, -0.5};
        spring.length = 9.0f;
        const float frequency = random.between(1.0f, 30.0f);  // rad/s
        spring.strength = massOf(world, slider) * frequency * frequency;
        ASSERT_TRUE(createField(world, spring).ok());
        SCOPED_TRACE(testing::Message() << seed << " rad/s " << frequency);
        const auto swingOver = [&](int steps) {
            double swing = 0.0;
            for (int i = 0; i < steps; ++i) {
                step(world, kStep);
                swing = std::max(swing, std::fabs(positionOf(world, slider).x - 1.0));
            }
            return swing;
        };
        const double first = swingOver(600);
        EXPECT_GT(first, 0.9);
        EXPECT_NEAR(swingOver(600) / first, 1.0, 0.02);
    }
}

TEST(SlowBodies, outsideEquilibriumDoNotFallAsleep) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random = Random::seeded(seed);
        World world = makeWorld();
        world.settings.sleeping = true;
        chooseScheme(random, world);
        const float radius = powerOfTen(random, -1.5f, 0.0f);
        const BodyId bubble = addBody(world, BodyKind::Dynamic, {0.0, 1.5}, circle(radius));
        const float rise = random.between(0.015f, 0.045f);  // rising speed, m/s; below the sleep speed
        FieldDefinition fluid = fieldOf(FieldKind::Buoyancy);
        fluid.density = 1.2f;
        fluid.linearDrag = (1.2f - 1.0f) * 10.0f / (1.2f * rise);
        ASSERT_TRUE(createField(world, fluid).ok());
        SCOPED_TRACE(testing::Message() << seed << " m/s " << rise);
        run(world, 600);
        EXPECT_NEAR(velocityOf(world, bubble).y, -rise, 0.02f * rise);
        run(world, 9000);  // 150 s, longer than the way to the surface takes
        EXPECT_LT(positionOf(world, bubble).y, static_cast<double>(radius));
        EXPECT_FALSE(isAwake(world, bubble));
    }
}

/// Builds a square net of springs between balls, with strengths that differ by factors up to 10^6.
std::vector<BodyId> netOf(Random& random, World& world, int size) {
    std::vector<BodyId> net;
    for (int i = 0; i < size * size; ++i) {
        net.push_back(addBody(world, BodyKind::Dynamic, {1.0 * (i % size), 1.0 * (i / size)},
                              circle(random.between(0.05f, 0.3f))));
    }
    const auto join = [&](std::size_t a, std::size_t b) {
        FieldDefinition spring = springOf(random, net[a], {}, 1.0f);
        spring.b = net[b];
        EXPECT_TRUE(createField(world, spring).ok());
    };
    for (int i = 0; i < size * size; ++i) {
        if (i % size + 1 < size) join(i, i + 1);
        if (i + size < size * size) join(i, i + size);
    }
    return net;
}

TEST(StiffFields, aNetOfSpringsKeepsItsMomentumAndHolds) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Random random = Random::seeded(seed);
        World world = makeWorld();
        world.settings.gravity = {};
        chooseScheme(random, world);
        SCOPED_TRACE(seed);
        const std::vector<BodyId> net = netOf(random, world, 4);
        ASSERT_TRUE(setVelocity(world, net[5], {2.0f, 1.0f}).ok());
        const auto momentum = [&] {
            Vec2 sum;
            for (const BodyId body : net) sum += massOf(world, body) * velocityOf(world, body);
            return sum;
        };
        const Vec2 before = momentum();
        double widest = 0.0;
        for (int i = 0; i < 300; ++i) {
            step(world, kStep);
            for (const BodyId body : net) {
                const Vec2 across = positionOf(world, body) - positionOf(world, net[0]);
                widest = std::max(widest, static_cast<double>(length(across)));
            }
        }
        EXPECT_LT(length(momentum() - before), 1e-3f * length(before));
        EXPECT_LT(widest, 10.0);
    }
}

}  // namespace
}  // namespace plumb::physics
