#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

/// Hangs a chain of `count` discs from the ground.
std::vector<JointId> hang(JointWorld& scene, int count) {
    std::vector<JointId> joints;
    BodyId above = scene.ground;
    for (int i = 0; i < count; ++i) {
        const BodyId disc = scene.disc({0.0, -0.5 - i});
        joints.push_back(scene.join(scene.define(JointKind::Revolute, above, disc, {0.0, -1.0 * i})));
        above = disc;
    }
    return joints;
}

TEST(RevoluteJoint, carriesAndReportsItsLoad) {
    JointWorld scene;
    const std::vector<JointId> joints = hang(scene, 5);

    scene.run(5.0f);

    for (std::size_t i = 0; i < joints.size(); ++i) {
        const float load = static_cast<float>(joints.size() - i) * JointWorld::kGravity;
        EXPECT_NEAR(jointForce(scene.world, joints[i]).y, load, 0.01f * load) << i;
        EXPECT_NEAR(jointForce(scene.world, joints[i]).x, 0.0f, 0.01f * load) << i;
        EXPECT_LT(length(scene.gapOf(joints[i])), 0.005f) << i;
    }
}

TEST(RevoluteJoint, keepsTheEnergyOfAPendulumForTenSeconds) {
    JointWorld scene;
    const BodyId bob = scene.disc({1.0, 0.0});
    const JointId joint = scene.join(scene.define(JointKind::Revolute, scene.ground, bob, {0.0, 0.0}));
    const double before = scene.energyOf(bob);

    scene.run(10.0f);

    const double height = 1.0 * JointWorld::kGravity;  // potential energy of 1 m in height, J
    EXPECT_NEAR(scene.energyOf(bob), before, 0.005 * height);
    EXPECT_LT(length(scene.gapOf(joint)), 0.002f);
}

TEST(RevoluteJoint, hasThePeriodOfAPhysicalPendulum) {
    JointWorld scene;
    const BodyId bob = scene.disc({0.05, -1.0});
    (void)scene.join(scene.define(JointKind::Revolute, scene.ground, bob, {0.0, 0.0}));

    const float period = scene.periodOf(0.0f, 10.0f, [&] { return scene.place(bob).x; });

    const float inertia = 1.0f * 1.0f + 0.125f;  // kg m2 about the pivot: m r2 + I
    EXPECT_NEAR(period, kTau * std::sqrt(inertia / (1.0f * JointWorld::kGravity)), 0.005f);
}

TEST(RevoluteJoint, keepsMomentumBetweenTwoFreeBodies) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId a = scene.disc({-0.5, 0.0}), b = scene.disc({0.5, 0.0}, 3.0f);
    (void)scene.join(scene.define(JointKind::Revolute, a, b, {0.0, 0.0}));
    (void)*setVelocity(scene.world, a, {0.0f, 4.0f});
    (void)*setAngularVelocity(scene.world, b, -5.0f);
    const auto spinOf = [&](BodyId body) {  // angular momentum about the origin
        const BodyMass& mass = scene.world.bodies.mass[body.index];
        return mass.mass * cross(scene.place(body), velocityOf(scene.world, body)) +
               mass.inertia * angularVelocityOf(scene.world, body);
    };
    const float spin = spinOf(a) + spinOf(b);

    scene.run(10.0f);

    EXPECT_NEAR(velocityOf(scene.world, a).y + 3.0f * velocityOf(scene.world, b).y, 4.0f, 1.0e-3f);
    EXPECT_NEAR(velocityOf(scene.world, a).x + 3.0f * velocityOf(scene.world, b).x, 0.0f, 1.0e-3f);
    EXPECT_NEAR(spinOf(a) + spinOf(b), spin, 0.02f * std::fabs(spin));
}

TEST(RevoluteJoint, worksWithTheStaticBodyOnEitherSide) {
    JointWorld first, second;
    const BodyId bobA = first.disc({0.5, 0.0}), bobB = second.disc({0.5, 0.0});
    (void)first.join(first.define(JointKind::Revolute, first.ground, bobA, {0.0, 0.0}));
    (void)second.join(second.define(JointKind::Revolute, bobB, second.ground, {0.0, 0.0}));

    first.run(2.0f);
    second.run(2.0f);

    EXPECT_NEAR(first.place(bobA).x, second.place(bobB).x, 1.0e-4f);
    EXPECT_NEAR(first.place(bobA).y, second.place(bobB).y, 1.0e-4f);
}

TEST(RevoluteJoint, stopsAtItsLimits) {
    JointWorld scene;
    const BodyId bob = scene.disc({1.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Revolute, scene.ground, bob, {0.0, 0.0});
    definition.limit = {true, -0.5f, 0.25f};
    const JointId joint = scene.join(definition);

    scene.run(10.0f);

    EXPECT_NEAR(scene.angle(bob), -0.5f, 0.005f);
    const float torque = JointWorld::kGravity * std::cos(0.5f);  // torque of the weight at 1 m
    EXPECT_NEAR(jointTorque(scene.world, joint), torque, 0.01f * torque);
}

TEST(RevoluteJoint, motorRotatesAtItsSpeedWithLimitedTorque) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const BodyId wheel = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Revolute, scene.ground, wheel, {0.0, 0.0});
    definition.motor = {true, 8.0f, 0.5f};
    (void)scene.join(definition);

    scene.run(1.0f);
    EXPECT_NEAR(angularVelocityOf(scene.world, wheel), 0.5f / 0.125f, 0.01f);  // t M / I
    scene.run(2.0f);
    EXPECT_NEAR(angularVelocityOf(scene.world, wheel), 8.0f, 0.001f);
}

TEST(RevoluteJoint, springOscillatesWithItsFrequency) {
    for (const float hertz : {0.5f, 2.0f, 5.0f}) {
        SCOPED_TRACE(hertz);
        JointWorld scene;
        scene.world.settings.gravity = {};
        const BodyId wheel = scene.disc({0.0, 0.0});
        JointDefinition definition = scene.define(JointKind::Revolute, scene.ground, wheel, {0.0, 0.0});
        definition.spring = {true, hertz, 0.0f, 0.3f};
        (void)scene.join(definition);
        const auto angle = [&] { return scene.angle(wheel); };

        EXPECT_NEAR(scene.periodOf(0.3f, 10.0f, angle), 1.0f / hertz, 0.005f / hertz);
        float highest = 0.0f;
        for (int i = 0; i < 150; ++i) {
            scene.run(JointWorld::kDt);
            highest = std::fmax(highest, angle());
        }
        EXPECT_NEAR(highest, 0.6f, 0.03f);  // the amplitude at the start
    }
}

TEST(RevoluteJoint, breaksExactlyAboveItsForce) {
    for (const float strength : {0.98f, 1.02f}) {
        SCOPED_TRACE(strength);
        JointWorld scene;
        const BodyId bob = scene.disc({0.0, -1.0});
        JointDefinition definition = scene.define(JointKind::Revolute, scene.ground, bob, {0.0, 0.0});
        definition.breakForce = strength * JointWorld::kGravity;  // relative to the hanging weight
        const JointId joint = scene.join(definition);
        bool broke = false;
        for (int i = 0; i < 60; ++i) {
            scene.run(JointWorld::kDt);
            broke = broke || (scene.world.brokenJoints.size() == 1 && scene.world.brokenJoints[0] == joint);
        }
        EXPECT_EQ(broke, strength < 1.0f);
        EXPECT_EQ(alive(scene.world, joint), strength > 1.0f);
    }
}

/// Regression: joint impulses of the previous step were looked up in groups that no longer existed. Detected
/// by builds with index checks (PLUMB_ASSERTS).
TEST(RevoluteJoint, impulsesAreNotReadFromRemovedGroups) {
    JointWorld scene;
    scene.disc({5.0, 0.0});
    const BodyId bob = scene.disc({0.0, -1.0});
    ASSERT_TRUE(setQuality(scene.world, bob, Quality{4}).ok());
    JointDefinition definition = scene.define(JointKind::Revolute, scene.ground, bob, {0.0, 0.0});
    definition.breakForce = 1000.0f;
    scene.world.settings.directJoints = false;
    const JointId joint = scene.join(definition);
    scene.run(3 * JointWorld::kDt);
    destroyBody(scene.world, bob);
    scene.run(3 * JointWorld::kDt);
    EXPECT_FALSE(alive(scene.world, joint));
    EXPECT_TRUE(scene.world.brokenJoints.empty());
}

}  // namespace
}  // namespace plumb::physics
