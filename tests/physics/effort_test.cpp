#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "physics/islands/substep_controller.hpp"

// The rule by which an island takes its quality, on islands whose answer is a formula.

namespace plumb::physics {
namespace {

constexpr float kTolerance = 0.001f;   // m
constexpr float kStep = 1.0f / 60.0f;  // s

/// An island whose error falls by `gain` for each quality, and follows a new one with a delay.
struct Island {
    SubstepController effort = begun(2, kStep);
    float load = 0.0f;     // m: its error at quality 0
    float gain = 4.0f;     // ratio
    float follows = 0.2f;  // part of the way in a step
    float error = 0.0f;    // m
    int changes = 0;

    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            const float goal = load * std::pow(gain, -static_cast<float>(effort.quality));
            error += follows * (goal - error);
            const Quality before = effort.quality;
            effort = judged(effort, error, kTolerance, 0, kStep);
            changes += effort.quality != before ? 1 : 0;
        }
    }
};

TEST(SubstepController, aLightIslandComesDownToTheCheapest) {
    Island island{.load = 0.0005f};
    island.run(300);
    EXPECT_EQ(island.effort.quality, 0);
    EXPECT_EQ(island.changes, 2);
}

TEST(SubstepController, aHardOneRisesByAsManyAsItsErrorSays) {
    Island island{.effort = begun(0, kStep), .load = 0.1f, .follows = 1.0f};
    island.run(6);
    EXPECT_EQ(island.effort.quality, 1) << "not all at once: it would hop";
    island.run(60);
    EXPECT_GE(island.effort.quality, 4);
    EXPECT_EQ(island.changes, island.effort.quality) << "one after the other";
    EXPECT_LE(island.error, kTolerance);
}

TEST(SubstepController, aBlowRaisesNothing) {
    Island island{.load = 0.0005f};
    island.run(300);
    island.changes = 0;
    for (int blow = 0; blow < 20; ++blow) {
        island.error = 0.05f;  // gone two steps later
        island.follows = 0.9f;
        island.run(10);
    }
    EXPECT_EQ(island.changes, 0);
}

TEST(SubstepController, keepsToTheToleranceWithoutFlicker) {
    Random random = Random::seeded(3);
    for (int i = 0; i < 300; ++i) {
        Island island{.load = kTolerance * std::pow(4.0f, random.between(-2.0f, 5.5f)),
                      .gain = random.between(2.8f, 5.0f),
                      .follows = random.between(0.03f, 0.9f)};
        if (island.load * std::pow(island.gain, -6.0f) > 0.9f * kTolerance) continue;
        island.run(600);
        SCOPED_TRACE(i);
        EXPECT_LE(island.error, kTolerance);
        island.changes = 0;
        float worst = 0.0f;
        for (int step = 0; step < 60 * 120; ++step) {
            island.run(1);
            worst = std::max(worst, island.error);
        }
        EXPECT_LE(worst, kTolerance);
        EXPECT_LE(island.changes, 20) << "in two minutes, gain " << island.gain << ", load " << island.load;
    }
}

TEST(SubstepController, comesDownWhenTheLoadIsGone) {
    Island island{.load = 0.1f};
    island.run(60 * 60);  // has learned that less does not do
    const Quality high = island.effort.quality;
    ASSERT_GE(high, 3);
    island.load = 0.0001f;
    island.run(600);
    EXPECT_EQ(island.effort.quality, 0);
}

TEST(SubstepController, whereQualityDoesNotHelpItIsNotBought) {
    Island island{.load = 0.05f, .gain = 1.0f};
    double substeps = 0.0;
    constexpr int kSteps = 60 * 120;
    for (int i = 0; i < kSteps; ++i) {
        island.run(1);
        substeps += std::exp2(static_cast<double>(island.effort.quality));
    }
    EXPECT_LE(island.effort.quality, 2);
    EXPECT_LT(substeps / kSteps, 1.5 * 4.0);
    island.gain = 4.0f;
    island.load = 0.3f;  // now it would help
    island.run(120);
    EXPECT_LE(island.error, kTolerance);
}

TEST(SubstepController, neverBelowWhatIsAskedForNorAboveTheMost) {
    SubstepController effort = begun(0, kStep);
    for (int i = 0; i < 1000; ++i) {
        effort = judged(effort, 0.0f, kTolerance, 3, kStep);
        EXPECT_EQ(effort.quality, 3);
    }
    for (int i = 0; i < 5000; ++i) {
        effort = judged(effort, 10.0f, kTolerance, 3, kStep);
        ASSERT_GE(effort.quality, 3);
        ASSERT_LE(effort.quality, kMaxQuality);
    }
}

SubstepController anyEffort(Random& random) {
    SubstepController effort;
    effort.quality = static_cast<Quality>(static_cast<int>(random.below(4)) - 1);
    effort.before = static_cast<Quality>(random.below(7));
    effort.phase = static_cast<SubstepPhase>(random.below(5));
    effort.patience = static_cast<std::uint8_t>(random.below(6));
    effort.wait = random.below(100);
    effort.error = random.unit();
    effort.first = random.unit();
    return effort;
}

bool same(const SubstepController& a, const SubstepController& b) {
    return a.quality == b.quality && a.before == b.before && a.phase == b.phase && a.patience == b.patience &&
           a.wait == b.wait && a.error == b.error && a.first == b.first;
}

TEST(SubstepController, islandsMergeToTheSameInAnyOrder) {
    Random random = Random::seeded(1);
    for (int i = 0; i < 1000; ++i) {
        const SubstepController a = anyEffort(random), b = anyEffort(random), c = anyEffort(random);
        EXPECT_TRUE(same(merged(a, b), merged(b, a)));
        EXPECT_TRUE(same(merged(merged(a, b), c), merged(a, merged(b, c))));
        EXPECT_TRUE(same(merged(a, a), a));
        EXPECT_EQ(merged(a, b).quality, std::max(a.quality, b.quality));
    }
}

}  // namespace
}  // namespace plumb::physics
