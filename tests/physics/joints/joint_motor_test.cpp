#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

TEST(MotorJoint, drivesToItsOffsetAndAngle) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId box = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Motor, scene.ground, box, {0.0, 0.0});
    definition.offset = {2.0f, -1.0f};
    definition.referenceAngle = 0.5f;
    definition.maxForce = 50.0f;
    definition.maxTorque = 5.0f;
    (void)scene.join(definition);

    scene.run(5.0f);

    EXPECT_NEAR(scene.place(box).x, 2.0f, 0.01f);
    EXPECT_NEAR(scene.place(box).y, -1.0f, 0.01f);
    EXPECT_NEAR(scene.angle(box), 0.5f, 0.01f);
}

TEST(MotorJoint, isLimitedToItsForceAndTorque) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId box = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Motor, scene.ground, box, {0.0, 0.0});
    definition.offset = {100.0f, 0.0f};
    definition.referenceAngle = 3.0f;
    definition.maxForce = 2.0f;
    definition.maxTorque = 0.01f;
    const JointId joint = scene.join(definition);

    scene.run(1.0f);

    EXPECT_NEAR(velocityOf(scene.world, box).x, 2.0f, 0.02f);
    EXPECT_NEAR(angularVelocityOf(scene.world, box), 0.01f / 0.125f, 0.002f);
    EXPECT_NEAR(length(jointForce(scene.world, joint)), 2.0f, 0.02f);
}

}  // namespace
}  // namespace plumb::physics
