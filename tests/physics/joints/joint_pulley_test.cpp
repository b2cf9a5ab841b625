#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

TEST(PulleyJoint, fallsLikeAtwoodsMachine) {
    JointWorld scene;
    const JointDefinition pulley = scene.definePulley(1.0f);
    const JointId joint = scene.join(pulley);

    scene.run(1.0f);

    const float acceleration = JointWorld::kGravity / 3.0f;  // (m2 - m1) g / (m1 + m2)
    EXPECT_NEAR(velocityOf(scene.world, pulley.b).y, -acceleration, 0.01f * acceleration);
    EXPECT_NEAR(velocityOf(scene.world, pulley.a).y, acceleration, 0.01f * acceleration);
    const float tension = 2.0f * 1.0f * 2.0f / 3.0f * JointWorld::kGravity;
    EXPECT_NEAR(jointForce(scene.world, joint).y, tension, 0.01f * tension);
    EXPECT_NEAR(-scene.place(pulley.a).y - scene.place(pulley.b).y, 6.0f, 0.005f);
}

TEST(PulleyJoint, balancesByItsRatio) {
    JointWorld scene;
    const JointDefinition pulley = scene.definePulley(2.0f);
    (void)scene.join(pulley);

    scene.run(10.0f);

    EXPECT_NEAR(scene.place(pulley.a).y, -3.0f, 0.02f);
    EXPECT_NEAR(scene.place(pulley.b).y, -3.0f, 0.02f);
}

}  // namespace
}  // namespace plumb::physics
