#include <gtest/gtest.h>

#include "joint_world.hpp"

namespace plumb::physics {
namespace {

TEST(PulleyJoint, fallsLikeAtwoodsMachine) {
    JointWorld scene;
    const BodyId light = scene.disc({-1.0, -3.0}, 1.0f), heavy = scene.disc({1.0, -3.0}, 2.0f);
    JointDefinition definition;
    definition.kind = JointKind::Pulley;
    definition.a = light;
    definition.b = heavy;
    definition.groundA = {-1.0f, 0.0f};
    definition.groundB = {1.0f, 0.0f};
    definition.length = 6.0f;
    const JointId joint = scene.join(definition);

    scene.run(1.0f);

    const float acceleration = JointWorld::kGravity / 3.0f;  // (m2 - m1) g / (m1 + m2)
    EXPECT_NEAR(velocityOf(scene.world, heavy).y, -acceleration, 0.01f * acceleration);
    EXPECT_NEAR(velocityOf(scene.world, light).y, acceleration, 0.01f * acceleration);
    const float tension = 2.0f * 1.0f * 2.0f / 3.0f * JointWorld::kGravity;
    EXPECT_NEAR(jointForce(scene.world, joint).y, tension, 0.01f * tension);
    EXPECT_NEAR(-scene.place(light).y - scene.place(heavy).y, 6.0f, 0.005f);
}

TEST(PulleyJoint, balancesByItsRatio) {
    JointWorld scene;
    const BodyId one = scene.disc({-1.0, -3.0}, 1.0f), two = scene.disc({1.0, -3.0}, 2.0f);
    JointDefinition definition;
    definition.kind = JointKind::Pulley;
    definition.a = one;
    definition.b = two;
    definition.groundA = {-1.0f, 0.0f};
    definition.groundB = {1.0f, 0.0f};
    definition.ratio = 2.0f;
    definition.length = 9.0f;
    (void)scene.join(definition);

    scene.run(10.0f);

    EXPECT_NEAR(scene.place(one).y, -3.0f, 0.02f);
    EXPECT_NEAR(scene.place(two).y, -3.0f, 0.02f);
}

}  // namespace
}  // namespace plumb::physics
