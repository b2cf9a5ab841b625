#include <gtest/gtest.h>

#include "joint_world.hpp"

namespace plumb::physics {
namespace {

TEST(MouseJoint, pullsToItsTargetWithoutSwingingOver) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId box = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Mouse, scene.ground, box, {0.0, 0.0});
    definition.target = {3.0, 1.0};
    (void)scene.join(definition);
    float furthest = 0.0f;
    for (int i = 0; i < 120; ++i) {
        scene.run(JointWorld::kDt);
        furthest = std::fmax(furthest, scene.place(box).x);
    }

    EXPECT_NEAR(scene.place(box).x, 3.0f, 0.001f);
    EXPECT_NEAR(scene.place(box).y, 1.0f, 0.001f);
    EXPECT_LT(furthest, 3.01f);
}

TEST(MouseJoint, pullsNoHarderThanItMay) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId box = scene.disc({0.0, 0.0}, 2.0f);
    JointDefinition definition = scene.define(JointKind::Mouse, scene.ground, box, {0.0, 0.0});
    definition.target = {1000.0, 0.0};
    definition.maxForce = 6.0f;
    const JointId joint = scene.join(definition);

    scene.run(1.0f);

    EXPECT_NEAR(velocityOf(scene.world, box).x, 6.0f / 2.0f, 0.01f);  // F t / m
    EXPECT_NEAR(jointForce(scene.world, joint).x, 6.0f, 0.01f);
}

TEST(MouseJoint, leavesItsFirstBodyAlone) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId other = scene.disc({5.0, 5.0}), box = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Mouse, other, box, {0.0, 0.0});
    definition.target = {1.0, 0.0};
    const JointId joint = scene.join(definition);

    scene.run(1.0f);
    (void)*setTarget(scene.world, joint, {-1.0, 0.0});
    scene.run(2.0f);

    EXPECT_EQ(scene.place(other), (Vec2{5.0f, 5.0f}));
    EXPECT_NEAR(scene.place(box).x, -1.0f, 0.001f);
}

}  // namespace
}  // namespace plumb::physics
