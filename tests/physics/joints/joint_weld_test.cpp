#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

TEST(WeldJoint, holdsACantileverRigidly) {
    JointWorld scene;
    const BodyId arm = scene.disc({1.0, 0.0});
    const JointId joint = scene.join(scene.define(JointKind::Weld, scene.ground, arm, {0.0, 0.0}));

    scene.run(10.0f);

    EXPECT_NEAR(scene.angle(arm), 0.0f, 0.005f);
    EXPECT_LT(length(scene.gapOf(joint)), 0.002f);
    EXPECT_NEAR(jointForce(scene.world, joint).y, JointWorld::kGravity, 0.01f * JointWorld::kGravity);
    EXPECT_NEAR(jointTorque(scene.world, joint), JointWorld::kGravity, 0.01f * JointWorld::kGravity);
}

TEST(WeldJoint, keepsTheReferenceAngle) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId piece = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Weld, scene.ground, piece, {0.0, 0.0});
    definition.referenceAngle = 0.7f;
    (void)scene.join(definition);

    scene.run(2.0f);

    EXPECT_NEAR(scene.angle(piece), 0.7f, 0.001f);
}

TEST(WeldJoint, withAFrequencyOscillatesWithIt) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId piece = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Weld, scene.ground, piece, {0.0, 0.0});
    definition.hertz = 2.0f;
    definition.dampingRatio = 0.0f;
    (void)scene.join(definition);
    (void)*setAngularVelocity(scene.world, piece, 3.0f);

    EXPECT_NEAR(scene.periodOf(0.0f, 10.0f, [&] { return scene.angle(piece); }), 0.5f, 0.003f);
}

// With two fixed rotations the relative angle cannot change: no torque can correct its error.
TEST(WeldJoint, appliesNoImpulseWhereNeitherBodyCanRotate) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId light = scene.disc({-2.0, 0.0}, 0.0003f), heavy = scene.disc({2.0, 0.0}, 3.0f);
    for (const BodyId body : {light, heavy}) setFixedRotation(scene.world, body, true);
    JointDefinition definition = scene.define(JointKind::Weld, light, heavy, {0.0, 0.0});
    definition.referenceAngle = 1.0e-6f;
    definition.breakTorque = 1.0f;
    const JointId joint = scene.join(definition);
    ASSERT_TRUE(setVelocity(scene.world, heavy, {1.0f, 0.5f}).ok());

    scene.run(1.0f);

    ASSERT_TRUE(alive(scene.world, joint));
    for (const BodyId body : {light, heavy}) {
        EXPECT_NEAR(velocityOf(scene.world, body).x, 3.0f / 3.0003f, 1.0e-5f);
        EXPECT_NEAR(velocityOf(scene.world, body).y, 1.5f / 3.0003f, 1.0e-5f);
    }
    EXPECT_NEAR(jointTorque(scene.world, joint), 0.0f, 1.0e-3f);
}

TEST(WeldJoint, breaksByTorque) {
    for (const float strength : {0.98f, 2.0f}) {
        SCOPED_TRACE(strength);
        JointWorld scene;
        const BodyId arm = scene.disc({1.0, 0.0});
        JointDefinition definition = scene.define(JointKind::Weld, scene.ground, arm, {0.0, 0.0});
        // Relative to the torque of the weight at 1 m, which acts suddenly.
        definition.breakTorque = strength * JointWorld::kGravity;
        const JointId joint = scene.join(definition);

        scene.run(1.0f);

        EXPECT_EQ(alive(scene.world, joint), strength > 1.0f);
    }
}

}  // namespace
}  // namespace plumb::physics
