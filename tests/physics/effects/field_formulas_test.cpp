#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "physics/shapes/shape_types.hpp"
#include "tests/physics/support/random_shapes.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Compares the effect of each field on a body of any pose and velocity in one short step with its formula.

using namespace plumb;
using namespace plumb::physics;

namespace {

constexpr float kStep = 1.0e-3f;  // s, so short that changes of the state within a step are negligible
constexpr std::uint64_t kFieldSeeds = 40;

/// A moving and rotating body of two shapes, with its center of mass off its origin; measures its
/// acceleration by a field in one step.
struct Flight {
    World world;
    Random random;
    BodyId body;

    explicit Flight(std::uint64_t seed) : random{Random::seeded(seed)} {
        world.settings.gravity = {};
        world.settings.quality = 0;
        body = flyer(test::randomPoint(random, 2.0f));
    }

    BodyId flyer(Vec2 place) {
        const BodyId made = *createBody(world, {.position = WorldPosition{place},
                                                .angle = random.between(-3.0f, 3.0f),
                                                .velocity = test::randomPoint(random, 3.0f),
                                                .angularVelocity = random.between(-2.0f, 2.0f)});
        const float density = random.between(0.5f, 3.0f);
        static_cast<void>(createShape(world, made,
                                      circle(random.between(0.2f, 0.6f), test::randomPoint(random, 0.5f)),
                                      {.density = density, .mask = 0}));
        static_cast<void>(createShape(world, made, box({0.3f, random.between(0.2f, 0.6f)}),
                                      {.density = density, .mask = 0}));
        return made;
    }

    struct Change {
        Vec2 linear;    // m/s2
        float angular;  // rad/s2
    };
    /// Acceleration of a body in one step by a field.
    Change changeBy(const FieldDefinition& field, BodyId of) {
        EXPECT_TRUE(createField(world, field).ok());
        const Vec2 before = velocityOf(world, of);
        const float spinBefore = angularVelocityOf(world, of);
        step(world, kStep);
        return {(velocityOf(world, of) - before) / kStep,
                (angularVelocityOf(world, of) - spinBefore) / kStep};
    }
    Change changeBy(const FieldDefinition& field) { return changeBy(field, body); }

    [[nodiscard]] Vec2 centre() const { return toVec2(centreOf(world, body)); }
    [[nodiscard]] float inverseMass() const { return 1.0f / massOf(world, body); }
    [[nodiscard]] float inverseInertia() const { return 1.0f / massDataOf(world, body).inertia; }
};

void expectChange(const Flight::Change& found, Vec2 linear, float angular = 0.0f) {
    const float slack = 2.0e-3f + 5.0e-3f * (length(linear) + std::fabs(angular));
    EXPECT_NEAR(found.linear.x, linear.x, slack);
    EXPECT_NEAR(found.linear.y, linear.y, slack);
    EXPECT_NEAR(found.angular, angular, slack);
}

}  // namespace

TEST(FieldFormulas, areaGravityPullsAlongItsDirectionOrToItsCenter) {
    for (std::uint64_t seed = 0; seed < kFieldSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Flight flight{seed};
        const Vec2 gravity = test::randomPoint(flight.random, 5.0f);
        flight.world.settings.gravity = gravity;
        const float scale = flight.random.between(-1.0f, 2.0f);
        ASSERT_TRUE(setGravityScale(flight.world, flight.body, scale));
        FieldDefinition field{.kind = FieldKind::AreaGravity, .replacesGravity = seed % 2 == 0};
        field.acceleration = test::randomPoint(flight.random, 5.0f);
        field.strength = flight.random.between(-5.0f, 5.0f);
        const Vec2 place = test::randomPoint(flight.random, 9.0f);
        field.place = WorldPosition{place};
        const Vec2 pull = field.acceleration + field.strength * normalized(place - flight.centre()) +
                          (field.replacesGravity ? Vec2{} : gravity);
        expectChange(flight.changeBy(field), scale * pull);
    }
}

TEST(FieldFormulas, attractorsPullByInverseSquareOrProportionally) {
    for (std::uint64_t seed = 0; seed < kFieldSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Flight flight{seed};
        FieldDefinition field{.kind = FieldKind::Attractor, .linear = seed % 3 == 0};
        field.strength = flight.random.between(-5.0f, 5.0f);
        field.length = seed % 2 == 0 ? 0.0f : flight.random.between(0.1f, 2.0f);
        Vec2 place = test::randomPoint(flight.random, 4.0f) + Vec2{6.0f, 0.0f};
        if (seed % 4 < 2) {
            field.place = WorldPosition{place};
        } else {
            field.a = flight.flyer(place);
            place = toVec2(centreOf(flight.world, field.a));
        }
        const Vec2 displacement = place - flight.centre();
        const float softened = dot(displacement, displacement) + field.length * field.length;
        const Vec2 wanted = field.linear ? field.strength * displacement
                                         : (field.strength / std::pow(softened, 1.5f)) * displacement;
        expectChange(flight.changeBy(field), wanted);
    }
    // At the center of an attractor the direction is undefined: no force.
    World world;
    world.settings.gravity = {};
    const BodyId body = addBody(world, BodyKind::Dynamic, {});
    static_cast<void>(createShape(world, body, circle(1.0f)));
    ASSERT_TRUE(createField(world, {.kind = FieldKind::Attractor, .strength = 5.0f}));
    step(world, kTick);
    EXPECT_EQ(velocityOf(world, body), Vec2{});
}

TEST(FieldFormulas, springsPullByTheirStretchAndDampTheirLengthChange) {
    for (std::uint64_t seed = 0; seed < kFieldSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Flight flight{seed};
        World& world = flight.world;
        FieldDefinition field{.kind = FieldKind::Spring, .a = flight.body};
        field.strength = flight.random.between(1.0f, 20.0f);
        field.damping = flight.random.between(0.0f, 5.0f);
        field.length = flight.random.between(0.0f, 4.0f);
        field.anchorA = test::randomPoint(flight.random, 1.0f);
        field.anchorB = test::randomPoint(flight.random, 1.0f);
        field.place = WorldPosition{test::randomPoint(flight.random, 5.0f)};
        if (seed % 2 == 0) field.b = flight.flyer(test::randomPoint(flight.random, 5.0f));
        struct End {
            Vec2 place, arm, velocity;
        };
        const auto endOf = [&](BodyId body, Vec2 anchor) {
            const WorldPosition at = worldPoint(world, body, anchor);
            return End{toVec2(at), at - centreOf(world, body), velocityAt(world, body, at)};
        };
        const End a = endOf(field.a, field.anchorA);
        const End b = field.b ? endOf(field.b, field.anchorB) : End{toVec2(field.place), {}, {}};
        const Vec2 along = normalized(b.place - a.place);
        const Vec2 force = (field.strength * (length(b.place - a.place) - field.length) +
                            field.damping * dot(along, b.velocity - a.velocity)) *
                           along;
        World copy = world;
        expectChange(flight.changeBy(field), flight.inverseMass() * force,
                     flight.inverseInertia() * cross(a.arm, force));
        if (!field.b) continue;
        flight.world = copy;
        const MassData mass = massDataOf(copy, field.b);
        expectChange(flight.changeBy(field, field.b), (-1.0f / mass.mass) * force,
                     -cross(b.arm, force) / mass.inertia);
    }
}

TEST(FieldFormulas, explosionsPushByWidthAndDistance) {
    for (std::uint64_t seed = 0; seed < kFieldSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Flight flight{seed};
        World& world = flight.world;
        const BodyId disc = addBody(world, BodyKind::Dynamic, {5.0, 1.0}, flight.random.between(-3.0f, 3.0f));
        const float radius = flight.random.between(0.2f, 0.8f);
        const Vec2 middle = test::randomPoint(flight.random, 0.5f);
        static_cast<void>(createShape(world, disc, circle(radius, middle), {.mask = 0}));
        static_cast<void>(createShape(world, disc, circle(0.1f, middle + Vec2{0.5f, 0.0f}),
                                      {.mask = 0, .isTrigger = true}));
        const MassData mass = massDataOf(world, disc);
        ASSERT_TRUE(setMassData(world, disc, {mass.mass, {0.3f, -0.2f}, mass.inertia}));
        FieldDefinition field{.kind = FieldKind::Explosion};
        field.place = WorldPosition{Vec2{5.0f, 1.0f} + test::randomPoint(flight.random, 3.0f)};
        field.radius = flight.random.between(1.0f, 4.0f);
        field.strength = flight.random.between(1.0f, 10.0f);
        const WorldPosition at = worldPoint(world, disc, middle);
        const Vec2 away = at - field.place;
        const float distance = std::max(length(away) - radius, 0.0f);
        const float size = std::max(field.strength * 2.0f * radius * (1.0f - distance / field.radius), 0.0f);
        const Vec2 impulse = size * normalized(away);
        ASSERT_TRUE(createField(world, field));
        step(world, kStep);
        const Vec2 wanted = impulse / mass.mass;
        EXPECT_NEAR(velocityOf(world, disc).x, wanted.x, 1.0e-3f * (1.0f + length(wanted)));
        EXPECT_NEAR(velocityOf(world, disc).y, wanted.y, 1.0e-3f * (1.0f + length(wanted)));
        const float turn = cross(at - centreOf(world, disc), impulse) / mass.inertia;
        EXPECT_NEAR(angularVelocityOf(world, disc), turn, 2.0e-3f * (1.0f + std::fabs(turn)));
        EXPECT_EQ(fieldCount(world), 0u) << "an explosion is removed after one step";
    }
}

TEST(FieldFormulas, windPushesByProjectedWidthAndSquaredSpeed) {
    for (std::uint64_t seed = 0; seed < kFieldSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world;
        world.settings.gravity = {};
        world.settings.quality = 0;
        const Vec2 velocity = test::randomPoint(random, 3.0f);
        const BodyId disc = *createBody(world, {.angle = 1.0f, .velocity = velocity});
        const float radius = random.between(0.3f, 1.0f);
        static_cast<void>(createShape(world, disc, circle(radius), {.density = 2.0f}));
        FieldDefinition field{.kind = FieldKind::Wind};
        field.velocity = test::randomPoint(random, 10.0f);
        field.density = random.between(0.1f, 2.0f);
        ASSERT_TRUE(createField(world, field));
        const Vec2 felt = field.velocity - velocity;
        step(world, kStep);
        const Vec2 wanted = (field.density * 2.0f * radius * length(felt) / massOf(world, disc)) * felt;
        const Vec2 found = (velocityOf(world, disc) - velocity) / kStep;
        EXPECT_NEAR(found.x, wanted.x, 1.0e-2f * (0.5f + length(wanted)));
        EXPECT_NEAR(found.y, wanted.y, 1.0e-2f * (0.5f + length(wanted)));
    }
}

TEST(FieldFormulas, gustsAreLimitedAndSmooth) {
    // A very light body moves with the velocity of the air.
    World world;
    world.settings.gravity = {};
    const BodyId leaf = addBody(world, BodyKind::Dynamic, {});
    static_cast<void>(createShape(world, leaf, circle(0.5f), {.density = 1.0e-3f}));
    FieldDefinition field{.kind = FieldKind::Wind};
    field.velocity = {6.0f, 8.0f};
    field.gust = 3.0f;
    field.gustSteps = 20;
    ASSERT_TRUE(createField(world, field));
    float low = 100.0f, high = 0.0f, before = 0.0f, jump = 0.0f;
    for (int i = 0; i < 2000; ++i) {
        step(world, kTick);
        const Vec2 air = velocityOf(world, leaf);
        const float speed = length(air);
        if (i > 20) {
            EXPECT_NEAR(cross(air, field.velocity), 0.0f, 0.05f) << "along the wind";
            low = std::min(low, speed);
            high = std::max(high, speed);
            jump = std::max(jump, std::fabs(speed - before));
        }
        before = speed;
    }
    EXPECT_GT(low, 10.0f - 3.01f);
    EXPECT_LT(low, 10.0f - 2.5f) << "some of a hundred gusts have nearly the maximum strength";
    EXPECT_LT(high, 10.0f + 3.01f);
    EXPECT_GT(high, 10.0f + 2.5f);
    EXPECT_LT(jump, 6.0f * 1.5f / 20.0f + 0.05f) << "the maximum slope of 3 t2 - 2 t3 is 1.5";
}

TEST(FieldFormulas, fluidsLiftAndDragSubmergedBodies) {
    for (std::uint64_t seed = 0; seed < kFieldSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Flight flight{seed};
        World& world = flight.world;
        const Vec2 gravity = test::randomPoint(flight.random, 10.0f) + Vec2{0.5f, 0.0f};
        world.settings.gravity = gravity;
        FieldDefinition field{.kind = FieldKind::Buoyancy};
        field.density = flight.random.between(0.5f, 2.0f);
        field.linearDrag = flight.random.between(0.0f, 3.0f);
        field.angularDrag = flight.random.between(0.0f, 3.0f);
        field.velocity = test::randomPoint(flight.random, 2.0f);
        // The whole body is submerged: the fluid is a large box or circle around it, or unbounded with its
        // surface far above the body.
        field.region = static_cast<RegionKind>(seed % 3);
        field.half = {50.0f, 40.0f};
        field.radius = 60.0f;
        if (field.region == RegionKind::Everywhere) field.place = WorldPosition{-30.0f * normalized(gravity)};
        // A trigger displaces no fluid.
        static_cast<void>(
            createShape(world, flight.body, circle(1.0f), {.density = 0.0f, .isTrigger = true}));
        const Vec2 centre = flight.centre(), velocity = velocityOf(world, flight.body);
        const float turning = angularVelocityOf(world, flight.body);
        Vec2 force;
        float torque = 0.0f, displaced = 0.0f;
        for (std::uint32_t s = world.bodies.info[flight.body.index].firstShape; s != kNone;
             s = world.shapes.info[s].next) {
            if ((world.shapes.info[s].flags & kTrigger) != 0) continue;
            const Geometry& g = world.shapes.geometry[s];
            const bool round = g.kind == ShapeKind::Circle;
            const float weight = field.density * (round ? kPi * g.radius * g.radius : 4.0f * g.b.x * g.b.y);
            const Vec2 arm = toVec2(worldPoint(world, flight.body, g.a)) - centre;
            const Vec2 part = -weight * gravity +
                              (field.linearDrag * weight) * (field.velocity - velocity - cross(turning, arm));
            force += part;
            torque += cross(arm, part);
            displaced += weight;
        }
        const Vec2 linear = gravity + flight.inverseMass() * force;
        const float angular =
            flight.inverseInertia() * torque - field.angularDrag * displaced * flight.inverseMass() * turning;
        expectChange(flight.changeBy(field), linear, angular);
    }
}
