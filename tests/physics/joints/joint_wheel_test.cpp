#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

/// Defines a wheel joint below a static car, with its suspension along y.
JointDefinition mount(const JointWorld& scene, BodyId wheel) {
    JointDefinition definition = scene.define(JointKind::Wheel, scene.ground, wheel, {0.0, 0.0});
    definition.axis = {0.0f, 1.0f};
    return definition;
}

TEST(WheelJoint, springCarriesTheLoadWithItsFrequency) {
    JointWorld scene;
    const BodyId wheel = scene.disc({0.0, 0.0});
    JointDefinition definition = mount(scene, wheel);
    definition.spring = {true, 2.0f, 0.0f};
    (void)scene.join(definition);
    const float omega = kTau * 2.0f, sag = JointWorld::kGravity / (omega * omega);

    EXPECT_NEAR(scene.periodOf(-sag, 10.0f, [&] { return scene.place(wheel).y; }), 0.5f, 0.003f);
    EXPECT_NEAR(scene.place(wheel).x, 0.0f, 0.002f);
}

TEST(WheelJoint, rotatesFreelyAndByItsMotor) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId free = scene.disc({0.0, 0.0}), driven = scene.disc({5.0, 0.0});
    (void)scene.join(mount(scene, free));
    JointDefinition definition = mount(scene, driven);
    definition.anchorA = {5.0f, 0.0f};
    definition.anchorB = {};
    definition.motor = {true, 4.0f, 0.25f};
    const JointId joint = scene.join(definition);
    (void)*setAngularVelocity(scene.world, free, 3.0f);

    scene.run(1.0f);
    EXPECT_NEAR(angularVelocityOf(scene.world, free), 3.0f, 1.0e-4f);
    EXPECT_NEAR(angularVelocityOf(scene.world, driven), 0.25f / 0.125f, 0.01f);
    EXPECT_NEAR(jointTorque(scene.world, joint), 0.25f, 0.0025f);
    scene.run(2.0f);
    EXPECT_NEAR(angularVelocityOf(scene.world, driven), 4.0f, 0.001f);
}

TEST(WheelJoint, stopsAtItsLimits) {
    JointWorld scene;
    const BodyId wheel = scene.disc({0.0, 0.0});
    JointDefinition definition = mount(scene, wheel);
    definition.limit = {true, -0.25f, 0.25f};
    (void)scene.join(definition);

    scene.run(10.0f);

    EXPECT_NEAR(scene.place(wheel).y, -0.25f, 0.002f);
}

}  // namespace
}  // namespace plumb::physics
