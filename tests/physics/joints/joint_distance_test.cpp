#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

JointDefinition between(const JointWorld& scene, BodyId body, float length) {
    JointDefinition definition;
    definition.kind = JointKind::Distance;
    definition.a = scene.ground;
    definition.b = body;
    definition.length = length;
    return definition;
}

TEST(DistanceJoint, asARodKeepsItsLengthAndCarriesTheLoad) {
    JointWorld scene;
    const BodyId bob = scene.disc({0.0, -2.0}, 3.0f);
    const JointId rod = scene.join(between(scene, bob, 2.0f));

    scene.run(5.0f);

    EXPECT_NEAR(scene.place(bob).y, -2.0f, 0.002f);
    EXPECT_NEAR(jointForce(scene.world, rod).y, 30.0f, 0.3f);
}

TEST(DistanceJoint, asARodSwingsForTenSecondsWithItsEnergy) {
    JointWorld scene;
    const BodyId bob = scene.disc({2.0, 0.0});
    (void)scene.join(between(scene, bob, 2.0f));
    const double before = scene.energyOf(bob);

    scene.run(10.0f);

    EXPECT_NEAR(scene.energyOf(bob), before, 0.005 * 2.0 * JointWorld::kGravity);
    EXPECT_NEAR(length(scene.place(bob)), 2.0f, 0.002f);
}

TEST(DistanceJoint, asARopeIsSlackUntilItIsTight) {
    JointWorld scene;
    const BodyId bob = scene.disc({0.0, -1.0});
    JointDefinition definition = between(scene, bob, 1.0f);
    definition.limit = {true, 0.0f, 3.0f};
    const JointId rope = scene.join(definition);

    scene.run(0.5f);
    EXPECT_NEAR(scene.place(bob).y, -1.0f - 0.5f * JointWorld::kGravity * 0.25f, 0.05f);
    EXPECT_EQ(jointForce(scene.world, rope), Vec2{});
    scene.run(9.5f);
    EXPECT_NEAR(scene.place(bob).y, -3.0f, 0.003f);
    EXPECT_NEAR(jointForce(scene.world, rope).y, JointWorld::kGravity, 0.1f);
}

TEST(DistanceJoint, asASpringHasItsFrequencyAndDeflection) {
    for (const float hertz : {0.5f, 1.0f, 2.0f, 5.0f}) {
        SCOPED_TRACE(hertz);
        JointWorld scene;
        const float omega = kTau * hertz, sag = JointWorld::kGravity / (omega * omega);
        const BodyId bob = scene.disc({0.0, -4.0});
        JointDefinition definition = between(scene, bob, 4.0f);
        definition.spring = {true, hertz, 0.0f};
        (void)scene.join(definition);

        const float period = scene.periodOf(-4.0f - sag, 10.0f, [&] { return scene.place(bob).y; });

        EXPECT_NEAR(period, 1.0f / hertz, 0.005f / hertz);
    }
}

TEST(DistanceJoint, asADampedSpringComesToRestAtItsEquilibrium) {
    JointWorld scene;
    const float hertz = 3.0f, omega = kTau * hertz;
    const BodyId bob = scene.disc({0.0, -4.0});
    JointDefinition definition = between(scene, bob, 4.0f);
    definition.spring = {true, hertz, 0.7f};
    const JointId spring = scene.join(definition);

    scene.run(10.0f);

    const float sag = JointWorld::kGravity / (omega * omega);
    EXPECT_NEAR(scene.place(bob).y, -4.0f - sag, 0.01f * sag);
    EXPECT_NEAR(jointForce(scene.world, spring).y, JointWorld::kGravity, 0.1f);
}

TEST(DistanceJoint, withCoincidingAnchorsAppliesNoForce) {
    JointWorld scene;
    const BodyId bob = scene.disc({0.0, 0.0});
    (void)scene.join(between(scene, bob, 1.0f));

    scene.run(1.0f);

    EXPECT_TRUE(isFinite(scene.place(bob)));
}

TEST(DistanceJoint, ropesKeepTheirLengthInFastCircles) {
    for (const float speed : {5.0f, 15.0f, 60.0f}) {
        SCOPED_TRACE(speed);
        JointWorld scene;
        scene.world.settings.gravity = {};
        const BodyId disc = scene.disc({1.0, 0.0});
        JointDefinition rope = scene.define(JointKind::Distance, scene.ground, disc, {});
        rope.anchorA = rope.anchorB = {};
        rope.limit = {true, 0.0f, 1.0f};
        (void)scene.join(rope);
        ASSERT_TRUE(setVelocity(scene.world, disc, {0.0f, speed}));
        for (int i = 0; i < 120; ++i) {
            scene.run(JointWorld::kDt);
            // The chord of a substep leaves the circle by half the square of its length.
            const float chord = speed * JointWorld::kDt / 4.0f;
            ASSERT_LT(length(scene.place(disc)), 1.0f + 2.0f * chord * chord + 0.001f) << i;
        }
    }
}

}  // namespace
}  // namespace plumb::physics
