#include <algorithm>

#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

/// Elongation of a chain of 20 links by a ball of 100 times a link's mass, m.
float stretchAfter(std::uint8_t iterations, float seconds) {
    JointWorld scene;
    scene.world.settings.directJoints = false;
    scene.world.settings.iterations = iterations;
    BodyId above = scene.ground;
    for (int i = 0; i <= 20; ++i) {
        const BodyId link = scene.disc({0.0, -0.5 - i}, i < 20 ? 0.1f : 10.0f);
        (void)scene.join(scene.define(JointKind::Revolute, above, link, {0.0, -1.0 * i}));
        above = link;
    }
    scene.run(seconds);
    return -20.5f - scene.place(above).y;
}

TEST(Iterations, doNotReduceTheElongationByCompliance) {
    constexpr float kRested = 30.0f;  // time until the oscillation has decayed, s
    const float once = stretchAfter(1, kRested);
    EXPECT_GT(once, 0.3f);
    EXPECT_NEAR(stretchAfter(8, kRested), once, 0.005f * once);
    EXPECT_NEAR(stretchAfter(64, kRested), once, 0.005f * once);
}

TEST(Iterations, areClampedToOneToSixtyFour) {
    EXPECT_EQ(stretchAfter(0, 0.5f), stretchAfter(1, 0.5f));
    EXPECT_EQ(stretchAfter(255, 0.5f), stretchAfter(64, 0.5f));
    EXPECT_NE(stretchAfter(2, 0.5f), stretchAfter(1, 0.5f));
}

TEST(Iterations, areClampedInTheSettings) {
    for (const int bad : {0, 1, 7, 64, 65, 255}) {
        Settings settings;
        settings.iterations = static_cast<std::uint8_t>(bad);
        bringIntoRange(settings);
        EXPECT_EQ(settings.iterations, std::clamp(bad, 1, 64));
    }
}

TEST(Iterations, addNoEnergyToAPendulumOnAnyJoint) {
    for (const JointKind kind : {JointKind::Revolute, JointKind::Distance}) {
        for (const int iterations : {2, 8}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << " with " << iterations);
            JointWorld scene;
            scene.world.settings.directJoints = false;  // selects the iterative SIMD solver
            scene.world.settings.iterations = static_cast<std::uint8_t>(iterations);
            const BodyId bob = scene.disc({1.0, 0.0});
            JointDefinition definition = scene.define(kind, scene.ground, bob, {});
            if (kind == JointKind::Distance) definition.anchorB = {};
            (void)scene.join(definition);
            const double before = scene.energyOf(bob);
            for (int i = 0; i < 600; ++i) {
                scene.run(JointWorld::kDt);
                ASSERT_NEAR(scene.energyOf(bob), before, 0.1) << i;  // the energy that oscillates is 10 J
            }
        }
    }
}

TEST(Iterations, haveNoEffectOnTrees) {
    for (const int iterations : {1, 2, 8}) {
        SCOPED_TRACE(iterations);
        JointWorld scene;
        scene.world.settings.iterations = static_cast<std::uint8_t>(iterations);
        const BodyId bob = scene.disc({1.0, 0.0}, 2.0f);
        const JointId joint = scene.join(scene.define(JointKind::Revolute, scene.ground, bob, {}));
        const double before = scene.energyOf(bob);
        float most = 0.0f;
        for (int i = 0; i < 600; ++i) {
            scene.run(JointWorld::kDt);
            ASSERT_NEAR(scene.energyOf(bob), before, 0.01) << i;
            most = std::fmax(most, length(jointForce(scene.world, joint)));
        }
        // Load at the bottom of the swing: m g + m v2 / r, with v2 = 2 g r / (1 + 1/8) for discs.
        const float load = 2.0f * JointWorld::kGravity * (1.0f + 2.0f / 1.125f);
        EXPECT_NEAR(most, load, 0.01f * load);
    }
}

}  // namespace
}  // namespace plumb::physics
