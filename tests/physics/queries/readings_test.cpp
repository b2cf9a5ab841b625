#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "physics/measure/measures.hpp"
#include "physics/model/fields.hpp"
#include "physics/model/joints.hpp"
#include "tests/physics/support/random_shapes.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Compares measurements of bodies and joints at any pose and velocity with formulas.

using namespace plumb;
using namespace plumb::physics;

namespace {

constexpr std::uint64_t kScenes = 40;

/// Two moving and rotating bodies, whose centers of mass differ from their positions.
struct Two {
    World world;
    Random random;
    BodyId a, b;

    explicit Two(std::uint64_t seed) : random{Random::seeded(seed)} {
        a = flyer();
        b = flyer();
    }
    BodyId flyer() {
        const BodyId made = *createBody(world, {.position = WorldPosition{test::randomPoint(random, 3.0f)},
                                                .angle = random.between(-1.4f, 1.4f),
                                                .velocity = test::randomPoint(random, 3.0f),
                                                .angularVelocity = random.between(-2.0f, 2.0f)});
        static_cast<void>(
            createShape(world, made, circle(0.5f, test::randomPoint(random, 0.5f)), {.mask = 0}));
        return made;
    }
    /// Rotation of B relative to A, rad.
    [[nodiscard]] float angle() const { return angleOf(between(rotationOf(world, a), rotationOf(world, b))); }
    [[nodiscard]] float spin() const { return angularVelocityOf(world, b) - angularVelocityOf(world, a); }
    struct Gap {
        Vec2 displacement, speed;
    };
    [[nodiscard]] Gap gapOf(const JointDefinition& d) const {
        const WorldPosition at = worldPoint(world, a, d.anchorA), to = worldPoint(world, b, d.anchorB);
        return {to - at, velocityAt(world, b, to) - velocityAt(world, a, at)};
    }
    JointReading read(JointDefinition& d) {
        d.a = a;
        d.b = b;
        const Result<JointId> made = createJoint(world, d);
        EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
        return readingOf(world, *made);
    }
    JointDefinition define(JointKind kind) {
        return {.kind = kind,
                .anchorA = test::randomPoint(random, 1.0f),
                .anchorB = test::randomPoint(random, 1.0f)};
    }
};

float beyond(float value, float lower, float upper) { return std::max({0.0f, lower - value, value - upper}); }

}  // namespace

TEST(Readings, ofHingesAreAngleAndAngularVelocity) {
    for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
        SCOPED_TRACE(seed);
        Two two{seed};
        JointDefinition d = two.define(JointKind::Revolute);
        d.referenceAngle = two.random.between(-1.0f, 1.0f);
        if (seed % 2 == 0) d.limit = {true, -0.2f, 0.3f};
        const JointReading reading = two.read(d);
        float angle = two.angle() - d.referenceAngle;
        if (angle > kPi) angle -= kTau;
        if (angle < -kPi) angle += kTau;
        EXPECT_NEAR(reading.value, angle, 1e-5f);
        EXPECT_NEAR(reading.speed, two.spin(), 1e-5f);
        EXPECT_NEAR(reading.separation, length(two.gapOf(d).displacement), 1e-5f);
        EXPECT_NEAR(reading.angularSeparation, d.limit.on ? beyond(angle, -0.2f, 0.3f) : 0.0f, 1e-5f);
    }
}

TEST(Readings, ofRodsAreLengthAndItsRateOfChange) {
    for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
        SCOPED_TRACE(seed);
        Two two{seed};
        JointDefinition d = two.define(JointKind::Distance);
        d.length = two.random.between(0.5f, 4.0f);
        if (seed % 3 == 1) d.limit = {true, 1.0f, 2.0f};
        if (seed % 3 == 2) d.spring = {true, 2.0f, 0.5f};
        const JointReading reading = two.read(d);
        const Two::Gap gap = two.gapOf(d);
        const float now = length(gap.displacement);
        EXPECT_NEAR(reading.value, now, 1e-5f);
        EXPECT_NEAR(reading.speed, dot(gap.speed, normalized(gap.displacement)), 1e-4f);
        const float wanted[] = {std::fabs(now - d.length), beyond(now, 1.0f, 2.0f), 0.0f};
        EXPECT_NEAR(reading.separation, wanted[seed % 3], 1e-5f);
        EXPECT_EQ(reading.angularSeparation, 0.0f);
    }
}

TEST(Readings, ofSlidersAreDisplacementAlongTheAxisAndItsSpeed) {
    for (std::uint64_t seed = 0; seed < 2 * kScenes; ++seed) {
        SCOPED_TRACE(seed);
        Two two{seed};
        const bool turns = seed % 2 == 0;
        JointDefinition d = two.define(turns ? JointKind::Wheel : JointKind::Prismatic);
        const Vec2 axis = rotate(test::randomRotation(two.random), {1.0f, 0.0f});
        d.axis = 3.0f * axis;
        if (seed % 4 < 2) d.limit = {true, -0.5f, 0.5f};
        const JointReading reading = two.read(d);
        const Two::Gap gap = two.gapOf(d);
        // Displacement of B along the axis after a time, in the rotating frame of A.
        const auto wayOf = [&](float time) {
            const Rot rotation =
                rotFromAngle(time * angularVelocityOf(two.world, two.a)) * rotationOf(two.world, two.a);
            return unrotate(rotation, gap.displacement + time * gap.speed);
        };
        const float value = dot(axis, wayOf(0.0f));
        EXPECT_NEAR(reading.value, value, 1e-5f);
        constexpr float kTime = 1e-3f;
        const float speed = (dot(axis, wayOf(kTime)) - dot(axis, wayOf(-kTime))) / (2.0f * kTime);
        EXPECT_NEAR(reading.speed, speed, 3e-3f);
        const float aside = std::fabs(cross(axis, wayOf(0.0f)));
        EXPECT_NEAR(reading.separation, std::max(aside, d.limit.on ? beyond(value, -0.5f, 0.5f) : 0.0f),
                    1e-5f);
        EXPECT_NEAR(reading.angularSeparation, turns ? 0.0f : std::fabs(two.angle()), 1e-5f);
    }
}

TEST(Readings, ofWeldMouseAndMotorJointsAreTheirErrors) {
    for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
        SCOPED_TRACE(seed);
        Two two{seed};
        JointDefinition weld = two.define(JointKind::Weld);
        JointReading reading = two.read(weld);
        EXPECT_NEAR(reading.value, two.angle(), 1e-5f);
        EXPECT_NEAR(reading.separation, length(two.gapOf(weld).displacement), 1e-5f);
        EXPECT_NEAR(reading.angularSeparation, std::fabs(two.angle()), 1e-5f);
        JointDefinition mouse = two.define(JointKind::Mouse);
        mouse.target = WorldPosition{test::randomPoint(two.random, 5.0f)};
        reading = two.read(mouse);
        EXPECT_NEAR(reading.separation, length(worldPoint(two.world, two.b, mouse.anchorB) - mouse.target),
                    1e-5f);
        JointDefinition motor = two.define(JointKind::Motor);
        motor.offset = test::randomPoint(two.random, 1.0f);
        reading = two.read(motor);
        const Vec2 wanted = rotate(rotationOf(two.world, two.a), motor.offset);
        EXPECT_NEAR(reading.separation, length(two.gapOf(motor).displacement - wanted), 1e-5f);
        JointDefinition filter = two.define(JointKind::Filter);
        reading = two.read(filter);
        EXPECT_EQ(reading.value, 0.0f);
        EXPECT_EQ(reading.separation, 0.0f);
        JointDefinition pulley = two.define(JointKind::Pulley);
        pulley.groundA = test::randomPoint(two.random, 5.0f);
        pulley.groundB = test::randomPoint(two.random, 5.0f);
        pulley.ratio = two.random.between(0.3f, 3.0f);
        pulley.length = two.random.between(1.0f, 9.0f);
        reading = two.read(pulley);
        const float ropes =
            length(worldPoint(two.world, two.a, pulley.anchorA) - WorldPosition{pulley.groundA}) +
            pulley.ratio *
                length(worldPoint(two.world, two.b, pulley.anchorB) - WorldPosition{pulley.groundB});
        EXPECT_NEAR(reading.separation, std::fabs(ropes - pulley.length), 1e-4f);
    }
}

TEST(Readings, ofEnergyIncludeAllBodiesSpringsAndAttractors) {
    for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
        SCOPED_TRACE(seed);
        Two two{seed};
        World& world = two.world;
        world.settings.gravity = test::randomPoint(two.random, 10.0f);
        ASSERT_TRUE(setGravityScale(world, two.a, 0.5f));
        const BodyId lift = *createBody(world, {.kind = BodyKind::Kinematic, .velocity = {9.0f, 9.0f}});
        static_cast<void>(createShape(world, lift, circle(1.0f)));
        double wanted = 0.0;
        for (const BodyId body : {two.a, two.b}) {
            const MassData mass = massDataOf(world, body);
            const Vec2 velocity = velocityOf(world, body), place = toVec2(centreOf(world, body));
            const float spin = angularVelocityOf(world, body), scale = body == two.a ? 0.5f : 1.0f;
            wanted += double{0.5f * mass.mass * dot(velocity, velocity) + 0.5f * mass.inertia * spin * spin -
                             mass.mass * scale * dot(world.settings.gravity, place)};
        }
        EXPECT_NEAR(energyOf(world), wanted, 1e-4);
        FieldDefinition spring{.kind = FieldKind::Spring, .strength = 3.0f, .length = 0.5f, .a = two.a};
        spring.anchorA = {0.3f, -0.2f};
        spring.anchorB = {0.1f, 0.4f};
        if (seed % 2 == 0) spring.b = two.b;
        spring.place = {1.0, 7.0};
        const WorldPosition end = spring.b ? worldPoint(world, two.b, spring.anchorB) : spring.place;
        const float stretch = length(end - worldPoint(world, two.a, spring.anchorA)) - 0.5f;
        wanted += double{1.5f * stretch * stretch};
        ASSERT_TRUE(createField(world, spring));
        EXPECT_NEAR(energyOf(world), wanted, 1e-4);
        FieldDefinition pull{.kind = FieldKind::Attractor, .linear = true, .strength = 2.0f};
        pull.place = {-1.0, 2.0};
        if (seed % 4 < 2) pull.a = two.b;  // an attractor does not attract its own body
        const WorldPosition centre = pull.a ? centreOf(world, two.b) : pull.place;
        for (const BodyId body : {two.a, two.b}) {
            const Vec2 displacement = centreOf(world, body) - centre;
            wanted += double{massOf(world, body) * dot(displacement, displacement)};
        }
        ASSERT_TRUE(createField(world, pull));
        EXPECT_NEAR(energyOf(world), wanted, 1e-3);
        pull.layers = 2;  // no body here is on this layer
        ASSERT_TRUE(createField(world, pull));
        EXPECT_NEAR(energyOf(world), wanted, 1e-3);
    }
}
