#include <cmath>

#include <gtest/gtest.h>

#include "physics/model/shape_wind.hpp"
#include "tests/physics/support/joint_world.hpp"

// Editing and reading joints while they are active, with the features of Box2D's joints.

namespace plumb::physics {
namespace {

JointDefinition randomJoint(JointWorld& scene, Random& random, JointKind kind, BodyId body) {
    JointDefinition d = scene.define(kind, scene.ground, body, {random.between(-0.5f, 0.5f), -0.5});
    d.axis = {random.between(-1.0f, 1.0f), 1.0f};
    d.length = random.between(0.5f, 1.5f);
    d.limit = {random.below(2) == 0, -random.unit(), random.unit()};
    d.motor = {random.below(2) == 0, random.between(-3.0f, 3.0f), random.between(1.0f, 100.0f)};
    d.spring = {random.below(3) == 0, random.between(1.0f, 5.0f), random.unit(), 0.0f};
    d.velocity = {random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f)};
    d.hertz = random.below(3) == 0 ? random.between(2.0f, 8.0f) : 0.0f;
    d.maxForce = random.between(5.0f, 50.0f);
    d.maxTorque = random.between(5.0f, 50.0f);
    d.reportForce = random.between(1.0f, 10.0f);
    d.collideConnected = random.below(2) == 0;
    d.quality = static_cast<Quality>(random.below(4)) - 1;
    return d;
}

TEST(JointEdits, changedJointsBehaveAsIfCreatedThatWay) {
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const auto kind = static_cast<JointKind>(seed % static_cast<std::uint64_t>(JointKind::Gear));
        JointWorld changed, created;
        const BodyId a = changed.disc({0.0, -1.0}), b = created.disc({0.0, -1.0});
        const JointDefinition before = randomJoint(changed, random, kind, a);
        const JointDefinition after = randomJoint(changed, random, kind, a);
        const JointId joint = changed.join(before);
        ASSERT_TRUE(setDefinition(changed.world, joint, after).ok());
        created.join(after);
        for (int i = 0; i < 60; ++i) {
            changed.run(JointWorld::kDt);
            created.run(JointWorld::kDt);
        }
        EXPECT_EQ(hashOf(changed.world), hashOf(created.world));
        EXPECT_EQ(changed.world.strainedJoints.size(), created.world.strainedJoints.size());
        EXPECT_EQ(changed.place(a), created.place(b));
    }
}

TEST(JointEdits, invalidChangesAreRejected) {
    JointWorld scene;
    const BodyId disc = scene.disc({0.0, -1.0});
    const JointId joint = scene.join(scene.define(JointKind::Revolute, scene.ground, disc, {}));
    const std::uint64_t before = hashOf(scene.world);
    EXPECT_FALSE(change(scene.world, joint, [](auto& d) { d.kind = JointKind::Weld; }).ok());
    EXPECT_FALSE(change(scene.world, joint, [](auto& d) { std::swap(d.a, d.b); }).ok());
    EXPECT_FALSE(change(scene.world, joint, [](auto& d) { d.limit = {true, 1.0f, -1.0f}; }).ok());
    EXPECT_FALSE(change(scene.world, joint, [](auto& d) { d.velocity.x = NAN; }).ok());
    EXPECT_FALSE(change(scene.world, JointId{}, [](auto&) {}).ok());
    EXPECT_FALSE(setKind(scene.world, disc, BodyKind::Kinematic).ok());
    EXPECT_EQ(hashOf(scene.world), before);
}

TEST(JointEdits, anchorsStayOnTheShapesWhenTheCenterOfMassMoves) {
    JointWorld scene;
    const BodyId disc = scene.disc({0.0, -1.0});
    const JointId joint = scene.join(scene.define(JointKind::Revolute, scene.ground, disc, {}));
    ASSERT_TRUE(setMassData(scene.world, disc, {2.0f, {0.3f, 0.2f}, 0.4f}).ok());
    EXPECT_LT(readingOf(scene.world, joint).separation, 1.0e-6f);
    scene.run(2.0f);
    EXPECT_LT(readingOf(scene.world, joint).separation, 1.0e-3f);
}

TEST(JointEdits, limitsMotorsAndSpringsTakeEffectInTheNextStep) {
    JointWorld scene;
    const BodyId disc = scene.disc({1.0, 0.0});
    const JointId joint = scene.join(scene.define(JointKind::Revolute, scene.ground, disc, {}));
    scene.run(0.5f);
    ASSERT_TRUE(change(scene.world, joint, [](auto& d) { d.motor = {true, 1.5f, 1.0e4f}; }).ok());
    scene.run(0.5f);
    JointReading now = readingOf(scene.world, joint);
    EXPECT_NEAR(now.speed, 1.5f, 1.0e-3f);
    // The motor lifts 1 kg at a lever arm of 1 m.
    EXPECT_NEAR(now.motorForce, 10.0f * std::cos(now.value), 0.7f);
    ASSERT_TRUE(change(scene.world, joint, [&](auto& d) {
                    d.motor.on = false;
                    d.limit = {true, now.value - 0.1f, now.value + 0.1f};
                }).ok());
    scene.run(2.0f);
    EXPECT_NEAR(readingOf(scene.world, joint).value, now.value - 0.1f, 0.01f);
    EXPECT_EQ(readingOf(scene.world, joint).motorForce, 0.0f);
}

TEST(JointEdits, motorSpeedsAndTargetsAreRejectedIfTheyHaveNoEffect) {
    for (int kind = 0; kind < static_cast<int>(JointKind::Gear); ++kind) {
        JointWorld scene;
        const BodyId disc = scene.disc({1.0, -1.0});
        const auto asked = static_cast<JointKind>(kind);
        const JointId joint = scene.join(scene.define(asked, scene.ground, disc, {}));
        const bool hasMotor = asked != JointKind::Weld && asked != JointKind::Mouse;
        EXPECT_EQ(setMotorSpeed(scene.world, joint, 2.0f).ok(), hasMotor) << kind;
        EXPECT_EQ(definitionOf(scene.world, joint).motor.speed, hasMotor ? 2.0f : 0.0f);
        EXPECT_EQ(setTarget(scene.world, joint, {3.0, 4.0}).ok(), asked == JointKind::Mouse) << kind;
        EXPECT_EQ(definitionOf(scene.world, joint).target.x, asked == JointKind::Mouse ? 3.0 : 0.0);
    }
    JointWorld scene;
    const JointId pulley = scene.join(scene.definePulley(1.0f));
    EXPECT_NE(setMotorSpeed(scene.world, pulley, 1.0f).error().text().find("no motor"), std::string::npos);
    EXPECT_FALSE(setTarget(scene.world, pulley, {}).ok());
}

TEST(JointEdits, readingsOfLengths) {
    JointWorld scene;
    const BodyId disc = scene.disc({0.0, -2.0});
    JointDefinition rope = scene.define(JointKind::Distance, scene.ground, disc, {0.0, -2.0});
    rope.anchorA = {};
    rope.limit = {true, 0.5f, 2.0f};
    const JointId joint = scene.join(rope);
    scene.run(0.5f);
    EXPECT_NEAR(readingOf(scene.world, joint).value, 2.0f, 0.01f);
    EXPECT_LT(readingOf(scene.world, joint).separation, 0.01f);
    ASSERT_TRUE(change(scene.world, joint, [](auto& d) { d.motor = {true, -1.0f, 1000.0f}; }).ok());
    scene.run(1.0f);
    EXPECT_NEAR(readingOf(scene.world, joint).speed, -1.0f, 0.01f);
    EXPECT_NEAR(readingOf(scene.world, joint).value, 1.0f, 0.03f);
    EXPECT_NEAR(std::fabs(readingOf(scene.world, joint).motorForce), 10.0f, 0.1f);
    scene.run(1.0f);
    EXPECT_NEAR(readingOf(scene.world, joint).value, 0.5f, 0.01f);  // at its upper limit
}

TEST(JointEdits, aSliderIsReadAlongItsAxis) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId disc = scene.disc({0.0, 0.0});
    JointDefinition d = scene.define(JointKind::Prismatic, scene.ground, disc, {});
    d.axis = {0.6f, 0.8f};
    const JointId joint = scene.join(d);
    ASSERT_TRUE(setVelocity(scene.world, disc, {1.2f, 1.6f}).ok());
    scene.run(1.0f);
    EXPECT_NEAR(readingOf(scene.world, joint).value, 2.0f, 1.0e-3f);
    EXPECT_NEAR(readingOf(scene.world, joint).speed, 2.0f, 1.0e-3f);
    EXPECT_LT(readingOf(scene.world, joint).separation, 1.0e-4f);
    EXPECT_LT(readingOf(scene.world, joint).angularSeparation, 1.0e-4f);
}

TEST(JointEdits, strainIsReportedBeforeItBreaks) {
    JointWorld scene;
    const BodyId disc = scene.disc({0.0, -1.0}, 2.0f);
    JointDefinition d = scene.define(JointKind::Weld, scene.ground, disc, {0.0, -1.0});
    d.reportForce = 15.0f;
    d.breakForce = 60.0f;
    const JointId joint = scene.join(d);
    for (const float gravity : {5.0f, 10.0f, 40.0f}) {
        scene.world.settings.gravity = {0.0f, -gravity};
        scene.run(0.5f);
        const bool strained = gravity * 2.0f > 15.0f, breaks = gravity * 2.0f > 60.0f;
        EXPECT_EQ(!scene.world.strainedJoints.empty(), strained && !breaks) << gravity;
        EXPECT_EQ(alive(scene.world, joint), !breaks) << gravity;
    }
}

TEST(JointEdits, aMotorJointKeepsAVelocityWithLimitedForce) {
    Random random = Random::seeded(3);
    for (int i = 0; i < 20; ++i) {
        JointWorld scene;
        scene.world.settings.gravity = {};
        const BodyId disc = scene.disc({random.between(-5.0f, 5.0f), random.between(-5.0f, 5.0f)}, 2.0f);
        JointDefinition d = scene.define(JointKind::Motor, scene.ground, disc, positionOf(scene.world, disc));
        d.motor = {.on = true, .speed = random.between(-5.0f, 5.0f)};
        d.velocity = {random.between(-8.0f, 8.0f), random.between(-8.0f, 8.0f)};
        d.maxForce = random.between(1.0f, 4.0f);
        d.maxTorque = 1000.0f;
        scene.join(d);
        scene.run(1.0f);
        const float reached = std::min(length(d.velocity), d.maxForce / 2.0f * 1.0f);
        EXPECT_NEAR(length(velocityOf(scene.world, disc)), reached, 0.02f * reached + 1.0e-3f) << i;
        EXPECT_NEAR(angularVelocityOf(scene.world, disc), d.motor.speed, 1.0e-3f * std::fabs(d.motor.speed));
        scene.run(22.0f);
        EXPECT_NEAR(velocityOf(scene.world, disc).x, d.velocity.x, 0.002f) << i;
        EXPECT_NEAR(velocityOf(scene.world, disc).y, d.velocity.y, 0.002f) << i;
    }
}

TEST(JointEdits, aWeldHasSeparateLinearAndAngularSprings) {
    // Rigid in position and springy in its angle: a torque rotates the disc, its anchor stays.
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId disc = scene.disc({0.0, 0.0});
    JointDefinition d = scene.define(JointKind::Weld, scene.ground, disc, {});
    d.spring = {true, 1.0f, 0.0f, 0.0f};
    const JointId joint = scene.join(d);
    ASSERT_TRUE(setAngularVelocity(scene.world, disc, 1.0f).ok());
    float furthest = 0.0f;
    int turns = 0;
    for (int i = 0; i < 300; ++i) {
        const bool before = angularVelocityOf(scene.world, disc) > 0.0f;
        scene.run(JointWorld::kDt);
        turns += before != (angularVelocityOf(scene.world, disc) > 0.0f) ? 1 : 0;
        furthest = std::max(furthest, readingOf(scene.world, joint).value);
    }
    EXPECT_EQ(turns, 10);                                // oscillations in 5 s at 1 Hz
    EXPECT_NEAR(furthest, 1.0f / (2.0f * kPi), 0.004f);  // amplitude = speed / (2 pi f)
    EXPECT_LT(readingOf(scene.world, joint).separation, 1.0e-4f);
    // Springy in position and rigid in its angle.
    ASSERT_TRUE(change(scene.world, joint, [](auto& w) {
                    w.hertz = 2.0f;
                    w.spring = {true, 1.0e4f, 1.0f, 0.0f};
                }).ok());
    scene.run(1.0f);
    EXPECT_LT(std::fabs(readingOf(scene.world, joint).value), 1.0e-3f);
    scene.world.settings.gravity = {0.0f, -10.0f};
    scene.run(10.0f);
    const float sag = 10.0f / std::pow(2.0f * kPi * 2.0f, 2.0f);
    EXPECT_NEAR(scene.place(disc).y, -sag, 0.02f * sag);
}

TEST(JointEdits, aFilterJointOnlyDisablesCollision) {
    JointWorld scene;
    scene.world.settings.sleeping = true;
    World& world = scene.world;
    ASSERT_TRUE(createShape(world, scene.ground, box({50.0f, 1.0f}, {0.0f, -1.0f})).ok());
    const auto crate = [&](WorldPosition place) {
        const BodyId body = *createBody(world, {.position = place});
        static_cast<void>(createShape(world, body, box({0.5f, 0.5f})));
        return body;
    };
    const BodyId a = crate({0.0, 0.5}), b = crate({0.3, 0.5}), c = crate({9.0, 0.5});
    const JointId filter = scene.join({.kind = JointKind::Filter, .a = a, .b = b});
    scene.join({.kind = JointKind::Filter, .a = a, .b = c});
    scene.run(2.0f);
    EXPECT_FALSE(isAwake(world, a) || isAwake(world, b));
    EXPECT_NEAR(positionOf(world, b).x, 0.3, 1.0e-3);
    setAwake(world, a, true);
    EXPECT_FALSE(isAwake(world, b) || isAwake(world, c));
    EXPECT_EQ(readingOf(world, filter).separation, 0.0f);
    setAwake(world, b, true);
    destroyJoint(world, filter);
    scene.run(4.0f);
    EXPECT_GT(std::fabs(positionOf(world, b).x - positionOf(world, a).x), 0.95);
}

TEST(JointEdits, treesAreSolvedDirectlyDespiteFilterJointsAndDisabledBodies) {
    JointWorld scene;
    BodyId above = scene.ground;
    std::vector<JointId> chain;
    std::vector<BodyId> links;
    for (int i = 0; i < 10; ++i) {
        links.push_back(scene.disc({0.0, -0.5 - i}, i == 9 ? 500.0f : 1.0f));
        chain.push_back(scene.join(
            scene.define(JointKind::Revolute, above, links.back(), {0.0, -static_cast<double>(i)})));
        above = links.back();
    }
    const BodyId extra = scene.disc({2.0, -5.0});
    const JointId hinge = scene.join(scene.define(JointKind::Revolute, links[4], extra, {1.0, -5.0}));
    scene.join({.kind = JointKind::Filter, .a = links[0], .b = links[9]});
    setEnabled(scene.world, extra, false);
    scene.run(3.0f);
    for (const JointId joint : chain) EXPECT_LT(readingOf(scene.world, joint).separation, 1.0e-4f);
    EXPECT_EQ(positionOf(scene.world, extra), (WorldPosition{2.0, -5.0}));
    setEnabled(scene.world, extra, true);
    scene.run(0.5f);
    EXPECT_NE(positionOf(scene.world, extra), (WorldPosition{2.0, -5.0}));
    EXPECT_LT(readingOf(scene.world, hinge).separation, 1.0e-3f) << "created while its body was disabled";
}

TEST(JointEdits, windDragsAndLiftsABoxLikeAFlatPlate) {
    for (const float angle : {0.2f, 0.7f, 1.2f}) {
        JointWorld scene;
        const BodyId body = *createBody(scene.world, {.angle = angle});
        const ShapeId plate = *createShape(scene.world, body, segment({0.0f, -1.0f}, {0.0f, 1.0f}));
        const ShapeId mass = *createShape(scene.world, body, circle(0.5f));
        ASSERT_TRUE(applyWind(scene.world, plate, {3.0f, 0.0f}, 0.5f, 0.25f).ok());
        const Vec2 force = scene.world.bodies.driveOf(body.index).force;
        const float width = 2.0f * std::cos(angle), square = 9.0f;  // projected width (m), speed^2 (m2/s2)
        EXPECT_NEAR(force.x, 0.5f * width * square, 1.0e-4f);
        EXPECT_NEAR(force.y, 0.25f * width * square * std::sin(angle), 1.0e-4f);
        clearForces(scene.world, body);
        ASSERT_TRUE(applyWind(scene.world, mass, {3.0f, 0.0f}, 0.5f, 0.25f).ok());
        EXPECT_NEAR(scene.world.bodies.driveOf(body.index).force.x, 0.5f * square, 1.0e-4f);
        EXPECT_NEAR(scene.world.bodies.driveOf(body.index).force.y, 0.0f, 1.0e-6f);
        EXPECT_NEAR(scene.world.bodies.driveOf(body.index).torque, 0.0f, 1.0e-6f);
        EXPECT_FALSE(applyWind(scene.world, mass, {NAN, 0.0f}, 0.5f, 0.25f).ok());
    }
    // Wind does not accelerate a very light body beyond the wind speed.
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId feather = scene.disc({}, 1.0e-4f);
    const ShapeId shape{0, scene.world.shapes.info[0].generation};
    for (int i = 0; i < 60; ++i) {
        ASSERT_TRUE(applyWind(scene.world, shape, {50.0f, 0.0f}, 1.0f, 0.0f).ok());
        scene.run(JointWorld::kDt);
        EXPECT_LE(velocityOf(scene.world, feather).x, 50.001f);
    }
    EXPECT_GT(velocityOf(scene.world, feather).x, 49.0f);
}

// Regression: a joint solved in a tree kept its graph color, so its bodies counted as touching in this world,
// but not in a copy.
TEST(JointEdits, anInactiveJointLeavesNoTrace) {
    JointWorld scene;
    const BodyId swinging = scene.disc({1.0, 0.0}), off = scene.disc({2.0, 0.0});
    (void)scene.join(scene.define(JointKind::Revolute, scene.ground, swinging, {0.0, 0.0}));
    const JointId idle = scene.join(scene.define(JointKind::Revolute, swinging, off, {2.0, 0.0}));
    scene.run(0.1f);
    setEnabled(scene.world, off, false);
    scene.run(0.1f);
    destroyJoint(scene.world, idle);
    World copy = scene.world;
    scene.run(0.5f);
    for (int i = 0; i < 30; ++i) step(copy, JointWorld::kDt);
    EXPECT_EQ(scene.place(swinging), toVec2(centreOf(copy, swinging)));
    EXPECT_EQ(hashOf(scene.world), hashOf(copy));
}

}  // namespace
}  // namespace plumb::physics
