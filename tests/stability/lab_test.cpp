#include "tests/accuracy/stability/lab.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/accuracy/stability/fair_scene.hpp"
#include "tests/accuracy/stability/maps.hpp"
#include "tests/accuracy/stability/random_run.hpp"

namespace plumb::stability {
namespace {

const Outline kCrate = scenes::box({0.5f, 0.5f});

TEST(StabilityLab, aCrateAtRestIsExact) {
    Lab lab{{}, {}};
    lab.floor();
    lab.add(kCrate, {0.0f, 0.5f});
    lab.run(2.0);
    EXPECT_EQ(scoreOf(lab.figures()), Score::Exact) << reasonOf(lab.figures());
}

TEST(StabilityLab, measuresPenetration) {
    Lab lab{{.gravity = 0.0}, {.size = 2.0, .rests = false}};
    lab.add(kCrate, {0.0f, 0.0f});
    lab.add(kCrate, {0.7f, 0.1f});
    EXPECT_NEAR(lab.figures().penetration, 0.15, 1e-6);  // overlap 0.3 m, size 2 m
}

TEST(StabilityLab, measuresJointErrors) {
    Lab lab{{.gravity = 0.0}, {.size = 0.5, .rests = false}};
    const BodyHandle hook = lab.addFixed(scenes::circle(0.05f), {}, {.group = -1});
    const BodyHandle link = lab.add(kCrate, {1.0f, 0.0f}, {.group = -1});
    lab.hinge(hook, link, {}, {-0.9f, 0.0f});
    EXPECT_NEAR(lab.figures().joints, 0.2, 1e-6);
}

TEST(StabilityLab, measuresDisplacementFromTheInitialPosition) {
    Lab lab{{.gravity = 10.0}, {.size = 1.0, .extent = 100.0}};
    const BodyHandle ball = lab.add(scenes::circle(0.5f), {0.0f, 0.0f});
    lab.setVelocity(ball, {1.0f, 0.0f});
    lab.run(1.0);
    // The error is the larger of 1 m sideways / size 1 m, and 5 m down / extent 100 m.
    EXPECT_NEAR(lab.figures().off, 1.0, 1e-3);
    EXPECT_NEAR(lab.figures().residual, std::sqrt(101.0) / std::sqrt(10.0), 1e-3);
}

TEST(StabilityLab, measuresEnergyGain) {
    Lab lab{{.gravity = 10.0}, {.rests = false}};
    const BodyHandle ball = lab.add(scenes::circle(0.5f), {0.0f, 10.0f});
    lab.run(0.5);
    EXPECT_NEAR(lab.figures().energyGain, 0.0, 1e-6) << "a fall gains no energy";
    lab.setVelocity(ball, {0.0f, -10.0f});  // 5 m/s of it are explained by the fall
    lab.run(0.1);
    EXPECT_NEAR(lab.figures().energyGain, 0.5 * (100.0 - 25.0) / 100.0, 1e-3);
    EXPECT_EQ(scoreOf(lab.figures()), Score::BlowsUp);
}

TEST(StabilityLab, drivenScenesMayGainEnergyButNotExcessSpeed) {
    Lab lab{{.gravity = 0.0}, {.mostSpeed = 2.0, .driven = true, .rests = false}};
    const BodyHandle ball = lab.add(scenes::circle(0.5f), {});
    lab.setVelocity(ball, {1.0f, 0.0f});
    lab.run(0.1);
    lab.setVelocity(ball, {5.0f, 0.0f});
    lab.run(0.1);
    EXPECT_EQ(lab.figures().energyGain, 0.0);
    EXPECT_NEAR(lab.figures().speeding, 2.5, 1e-3);
}

TEST(StabilityLab, speedGainedByFallingIsNotCounted) {
    Lab lab{{.gravity = 10.0}, {.mostSpeed = 1.0, .rests = false}};
    lab.add(scenes::circle(0.5f), {});
    lab.run(2.0);
    EXPECT_LT(lab.figures().speeding, 0.1);  // not 0 because of rounding at 20 m/s
}

TEST(StabilityLab, energyOfOverlappingBodiesIsMeasuredAfterTheirSeparation) {
    Lab lab{{.gravity = 0.0}, {.rests = false, .overlapped = true}};
    lab.add(kCrate, {0.0f, 0.0f});
    const BodyHandle other = lab.add(kCrate, {0.8f, 0.0f});
    lab.run(0.5);
    EXPECT_GT(lab.velocity(other).x, 0.0f);
    EXPECT_LE(lab.figures().energyGain, 0.01);
}

TEST(StabilityLab, rejectedBodiesCountAsBlowUp) {
    Lab lab{{}, {}};
    lab.add(scenes::circle(1.0e-9f), {});
    EXPECT_EQ(scoreOf(lab.figures()), Score::BlowsUp);
}

TEST(StabilityLab, theOriginOffsetsTheWholeScene) {
    Lab lab{{.origin = 1.0e6}, {}};
    const BodyHandle crate = lab.add(kCrate, {0.25f, 0.5f});
    EXPECT_EQ(physics::centreOf(lab.world(), lab.idOf(crate)).x, 1.0e6 + 0.25);
    EXPECT_EQ(lab.x(crate), 0.25);
}

TEST(StabilityLab, fairScenesStartWithoutOverlapsAndHaveContacts) {
    int met = 0, hinged = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        FairScene scene{seed};
        physics::World before = scene.world();
        physics::step(before, 1.0e-4f);
        for (const physics::Contact& contact : before.contacts) {
            const bool deep = contact.count > 0 && contact.separation0 < -0.15f;
            EXPECT_FALSE(deep) << "scene " << seed;
        }
        hinged += before.joints.size() > 0 ? 1 : 0;
        scene.run();
        EXPECT_TRUE(scene.isSound()) << "scene " << seed;
        met += scene.world().contacts.empty() ? 0 : 1;
    }
    EXPECT_GT(met, 50);
    EXPECT_GT(hinged, 20);
}

}  // namespace
}  // namespace plumb::stability
