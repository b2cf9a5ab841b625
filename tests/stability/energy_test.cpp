#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "tests/accuracy/stability/fair_scene.hpp"
#include "tests/accuracy/stability/lab.hpp"

// Energy that came from nowhere once, and must not again.

namespace plumb::stability {
namespace {

/// Most energy of a bouncing ball over that at the start, minus 1.
double gainOfBouncing(double radius, double height, double step) {
    const Material rubber{.friction = 0.0f, .bounciness = 1.0f};
    Lab lab{{.step = step}, {.rests = false}};
    lab.floor(rubber);
    lab.add(scenes::circle(static_cast<float>(radius)), {0.0f, static_cast<float>(height + radius)}, rubber);
    lab.run(10.0);
    return lab.figures().energyGain;
}

// What was swept and set back to the floor kept the speed of where it would have been below it.
TEST(StabilityEnergy, whatIsSetBackToTheFloorThatItFellThroughGainsNothing) {
    EXPECT_LE(gainOfBouncing(0.5, 2.0, 1.0 / 15.0), 0.01);
    for (const double radius : {0.01, 0.05, 0.1}) {
        for (const double height : {1.0, 3.0, 10.0})
            EXPECT_LE(gainOfBouncing(radius, height, 1.0 / 60.0), 0.01) << radius << " m, " << height << " m";
    }
}

// A small body on a long arm, thrown about, was spun until its numbers went bad.
TEST(StabilityEnergy, aSpinHasAnEnd) {
    FairScene scene{4616};
    scene.run();
    EXPECT_TRUE(scene.isSound());
    const physics::World& world = scene.world();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const float spin = std::fabs(world.bodies.motion[i].angularVelocity);
        EXPECT_LE(spin * world.bodies.info[i].reach, 1.001f * world.settings.maxSpeed) << "body " << i;
    }
    // Its speed is within the limit of the world.
    Lab lab{{.gravity = 0.0}, {.rests = false}};
    const BodyHandle plank = lab.add(scenes::box({1.0f, 0.1f}), {});
    lab.setVelocity(plank, {}, 1000.0);
    lab.run(1.0);
    EXPECT_FLOAT_EQ(physics::angularVelocityOf(lab.world(), lab.idOf(plank)), 1000.0f);
}

// What each of these scenes got energy from, before.
TEST(StabilityEnergy, doesNotComeFromNowhereInScenesWhereItDid) {
    constexpr std::pair<int, const char*> kScenes[] = {
        {26, "a joint that something tore open hurled its bodies together"},
        {3261, "the same, with arms of a hundred times the bodies' size"},
        {5266, "a sweep stopped one of two joined bodies at a wall"},
        {1102, "what was set back from a wall kept what it had gained by falling on"},
        {5705, "the same of two bodies with two joints"},
        {5387, "impulses of joints with long arms and of contacts grew by turns"},
        {6405, "the same, until numbers were too large to be squared"},
        {166, "what landed on a corner bounced off faster than it came"},
        {1414, "the same of a plank that flew into a wall"},
        {673, "a blow ran on through bodies that pressed each other"},
        {5253, "the same, of a heavy one onto a light one on the ground"},
        {39041, "a body was struck while another pressed it to the ground"},
        {84379, "a ball with two points at a wall left it spinning"},
        {258929, "a rod that spun faster than its contact follows stuck in the floor at full speed"},
        {9049, "what went wrong once counted as what a group had"},
        {66164, "a light body whipped about a heavy one that crept"},
        {77111, "a sweep stopped one of several joined bodies that a joint had hurled"},
        {103041, "a long arm levered a heavy body up from a light one jammed in the floor"},
        {103327, "a weld between two that cannot be turned pushed them both"},
        {103823, "a light body on a long arm was hurled across the pit"},
        {182496, "joints that closed hurled bodies up and down"},
    };
    for (const auto& [seed, reason] : kScenes) {
        FairScene scene{static_cast<std::uint64_t>(seed)};
        scene.run();
        EXPECT_TRUE(scene.isSound()) << seed << ": " << reason;
        EXPECT_LE(scene.energyGain(), kMaxEnergyGain) << seed << ": " << reason;
    }
}

// Of all scenes with joints one in eight gained, of the others one in 400.
TEST(StabilityEnergy, doesNotGrowInAThousandRandomScenes) {
    int jointed = 0, loose = 0;
    for (std::uint64_t seed = 1000; seed < 2000; ++seed) {
        FairScene scene{seed};
        ++(scene.hasJoints() ? jointed : loose);
        scene.run();
        EXPECT_TRUE(scene.isSound()) << seed;
        EXPECT_LE(scene.energyGain(), kMaxEnergyGain) << seed;
    }
    EXPECT_GT(jointed, 300);
    EXPECT_GT(loose, 300);
}

}  // namespace
}  // namespace plumb::stability
