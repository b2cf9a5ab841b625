#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

JointDefinition slide(const JointWorld& scene, BodyId body, Vec2 axis) {
    JointDefinition definition = scene.define(JointKind::Prismatic, scene.ground, body, {0.0, 0.0});
    definition.axis = axis;
    return definition;
}

TEST(PrismaticJoint, slidesAlongItsAxisLikeOnAnIncline) {
    JointWorld scene;
    const BodyId car = scene.disc({0.0, 0.0});
    (void)scene.join(slide(scene, car, {0.8f, -0.6f}));

    scene.run(1.0f);

    const Vec2 place = scene.place(car);
    const float distance = 0.5f * JointWorld::kGravity * 0.6f;  // m, along the axis
    EXPECT_NEAR(dot(place, {0.8f, -0.6f}), distance, 0.02f * distance);
    EXPECT_NEAR(dot(place, {0.6f, 0.8f}), 0.0f, 0.002f);
    EXPECT_NEAR(scene.angle(car), 0.0f, 0.001f);
}

TEST(PrismaticJoint, carriesPerpendicularForceAndTorque) {
    JointWorld scene;
    const BodyId arm = scene.disc({2.0, 0.0});  // 2 m from the slider's anchor
    const JointId joint = scene.join(slide(scene, arm, {1.0f, 0.0f}));

    scene.run(5.0f);

    EXPECT_NEAR(jointForce(scene.world, joint).y, JointWorld::kGravity, 0.01f * JointWorld::kGravity);
    EXPECT_NEAR(jointTorque(scene.world, joint), 2.0f * JointWorld::kGravity, 0.02f * JointWorld::kGravity);
    EXPECT_NEAR(scene.angle(arm), 0.0f, 0.005f);
}

TEST(PrismaticJoint, stopsAtItsLimitsWithTheForceOfTheLoad) {
    JointWorld scene;
    const BodyId car = scene.disc({0.0, 0.0});
    JointDefinition definition = slide(scene, car, {0.0f, 1.0f});
    definition.limit = {true, -1.5f, 2.0f};
    const JointId joint = scene.join(definition);

    scene.run(10.0f);

    EXPECT_NEAR(scene.place(car).y, -1.5f, 0.003f);
    EXPECT_NEAR(jointForce(scene.world, joint).y, JointWorld::kGravity, 0.01f * JointWorld::kGravity);
}

TEST(PrismaticJoint, motorLiftsLoadsUpToItsForce) {
    for (const float force : {0.9f, 1.5f}) {
        SCOPED_TRACE(force);
        JointWorld scene;
        const BodyId lift = scene.disc({0.0, 0.0});
        JointDefinition definition = slide(scene, lift, {0.0f, 1.0f});
        definition.motor = {true, 2.0f, force * JointWorld::kGravity};
        (void)scene.join(definition);

        scene.run(2.0f);

        // Speed after 2 s if the motor is too weak, m/s.
        const float sinking = (force - 1.0f) * JointWorld::kGravity * 2.0f;
        EXPECT_NEAR(velocityOf(scene.world, lift).y, force > 1.0f ? 2.0f : sinking, 0.02f);
    }
}

TEST(PrismaticJoint, springHasItsFrequency) {
    JointWorld scene;
    const BodyId bob = scene.disc({0.0, 0.0});
    JointDefinition definition = slide(scene, bob, {0.0f, 1.0f});
    definition.spring = {true, 1.5f, 0.0f, 0.0f};
    (void)scene.join(definition);
    const float omega = kTau * 1.5f, sag = JointWorld::kGravity / (omega * omega);

    const float period = scene.periodOf(-sag, 10.0f, [&] { return scene.place(bob).y; });

    EXPECT_NEAR(period, 1.0f / 1.5f, 0.004f);
}

TEST(PrismaticJoint, keepsItsAxisInARotatingBody) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId rail = scene.disc({0.0, 0.0}, 100.0f), bead = scene.disc({1.0, 0.0}, 0.1f);
    JointDefinition definition = scene.define(JointKind::Prismatic, rail, bead, {0.0, 0.0});
    definition.limit = {true, -0.5f, 0.5f};
    (void)scene.join(definition);
    (void)*setAngularVelocity(scene.world, rail, 6.0f);

    scene.run(10.0f);

    const Vec2 seen =
        unrotate(rotationOf(scene.world, rail), centreOf(scene.world, bead) - centreOf(scene.world, rail));
    EXPECT_NEAR(seen.y, 0.0f, 0.01f);
    EXPECT_NEAR(seen.x, 1.5f, 0.02f);
    EXPECT_NEAR(angularVelocityOf(scene.world, rail), angularVelocityOf(scene.world, bead), 0.01f);
}

}  // namespace
}  // namespace plumb::physics
