#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

/// Two wheels on axles, coupled by a gear joint.
struct Gears : JointWorld {
    BodyId first, second;
    JointId axleA, axleB, gear;

    explicit Gears(float ratio) {
        world.settings.gravity = {};
        first = disc({0.0, 0.0});
        second = disc({2.0, 0.0});
        axleA = join(define(JointKind::Revolute, ground, first, {0.0, 0.0}));
        axleB = join(define(JointKind::Revolute, ground, second, {2.0, 0.0}));
        JointDefinition definition;
        definition.kind = JointKind::Gear;
        definition.a = first;
        definition.b = second;
        definition.jointA = axleA;
        definition.jointB = axleB;
        definition.ratio = ratio;
        gear = join(definition);
    }
};

TEST(GearJoint, rotatesTheSecondWheelByItsRatioForManyRevolutions) {
    Gears scene{2.0f};
    (void)*setAngularVelocity(scene.world, scene.first, 12.0f);

    scene.run(10.0f);

    EXPECT_NEAR(
        angularVelocityOf(scene.world, scene.first) + 2.0f * angularVelocityOf(scene.world, scene.second),
        0.0f, 1.0e-3f);
    EXPECT_GT(angularVelocityOf(scene.world, scene.first), 1.0f);
    const float turns = scene.angle(scene.first) + 2.0f * scene.angle(scene.second);
    EXPECT_NEAR(turns - kTau * std::floor(turns / kTau + 0.5f), 0.0f, 0.01f);
}

TEST(GearJoint, transmitsTorqueByItsRatio) {
    Gears scene{2.0f};
    for (int i = 0; i < 60; ++i) {  // torque of 1 N m on the first wheel
        (void)*applyTorque(scene.world, scene.first, 1.0f);
        scene.run(JointWorld::kDt);
    }

    // With w1 = -2 w2, gear force f, and I the inertia: 1 = I a1 + f and 2 f = I a2, so a1 = 1 / (I + I / 4).
    EXPECT_NEAR(angularVelocityOf(scene.world, scene.first), 1.0f / (0.125f * 1.25f), 0.05f);
}

TEST(GearJoint, correctsItsErrorAlsoIfItIsEditedMeanwhile) {
    for (const bool switches : {false, true}) {
        SCOPED_TRACE(switches);
        Gears scene{1.0f};
        // drives both wheels in the same direction, which the gear prevents
        const auto drive = [&](bool on) {
            for (const JointId axle : {scene.axleA, scene.axleB})
                ASSERT_TRUE(change(scene.world, axle, [on](auto& d) { d.motor = {on, 2.0f, 1.0e6f}; }).ok());
        };
        const auto sum = [&] { return scene.angle(scene.first) + scene.angle(scene.second); };
        drive(true);
        scene.run(0.2f);
        EXPECT_GT(sum(), 0.1f);
        drive(false);
        if (switches) {
            ASSERT_TRUE(change(scene.world, scene.gear, [](auto& d) { d.breakTorque = 1.0e9f; }).ok());
        }
        scene.run(5.0f);
        EXPECT_NEAR(sum(), 0.0f, 1.0e-3f);
    }
}

TEST(GearJoint, isDestroyedWithEitherOfItsJoints) {
    for (const bool first : {true, false}) {
        Gears scene{1.0f};
        const JointId other =
            scene.join(scene.define(JointKind::Revolute, scene.ground, scene.disc({9.0, 0.0}), {9.0, 0.0}));
        destroyJoint(scene.world, other);
        EXPECT_TRUE(alive(scene.world, scene.gear));
        destroyJoint(scene.world, first ? scene.axleA : scene.axleB);
        EXPECT_FALSE(alive(scene.world, scene.gear));
        EXPECT_TRUE(alive(scene.world, first ? scene.axleB : scene.axleA));
        (void)*setAngularVelocity(scene.world, scene.first, 2.0f);

        scene.run(1.0f);

        EXPECT_NEAR(angularVelocityOf(scene.world, scene.second), 0.0f, 1.0e-6f);
    }
}

TEST(GearJoint, isDestroyedWithABodyOfItsJointsOrWhenOneBreaks) {
    for (const bool breaks : {true, false}) {
        Gears scene{1.0f};
        if (breaks) {
            ASSERT_TRUE(change(scene.world, scene.axleA, [](auto& d) { d.breakForce = 5.0f; }).ok());
            ASSERT_TRUE(applyForce(scene.world, scene.first, {0.0f, 1000.0f}).ok());
            scene.run(JointWorld::kDt);
        } else {
            destroyBody(scene.world, scene.first);
        }
        EXPECT_FALSE(alive(scene.world, scene.axleA));
        EXPECT_FALSE(alive(scene.world, scene.gear));
        EXPECT_EQ(scene.world.bodies.info[scene.second.index].firstJoint, scene.axleB.index);
        scene.run(1.0f);
    }
}

}  // namespace
}  // namespace plumb::physics
