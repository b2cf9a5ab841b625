#include "physics/islands/substep_controller.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "physics/tuning.hpp"

// Tests the rule that selects the quality of an island, with simulated islands whose answer is a formula.

namespace plumb::physics {
namespace {

constexpr float kTolerance = 0.001f;   // m
constexpr float kStep = 1.0f / 60.0f;  // s

/// A simulated island whose error falls by the factor `gain` per quality level and follows a change with a
/// delay.
struct Island {
    SubstepController effort = begun(2, kStep);
    float load = 0.0f;     // error at quality 0, m
    float gain = 4.0f;     // ratio of the errors of two successive quality levels
    float follows = 0.2f;  // fraction of the remaining difference per step
    float error = 0.0f;    // current error, m
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

TEST(SubstepController, aLightIslandGetsTheLowestQuality) {
    Island island{.load = 0.0005f};
    island.run(300);
    EXPECT_EQ(island.effort.quality, 0);
    EXPECT_EQ(island.changes, 2);
}

TEST(SubstepController, aHardIslandRisesByTheLevelsThatItsErrorRequires) {
    Island island{.effort = begun(0, kStep), .load = 0.1f, .follows = 1.0f};
    island.run(6);
    EXPECT_EQ(island.effort.quality, 1) << "a larger rise at once would make bodies hop";
    island.run(60);
    EXPECT_GE(island.effort.quality, 4);
    EXPECT_EQ(island.changes, island.effort.quality) << "each change must be of one level";
    EXPECT_LE(island.error, kTolerance);
}

TEST(SubstepController, aShortShockDoesNotRaiseTheQuality) {
    Island island{.load = 0.0005f};
    island.run(300);
    island.changes = 0;
    for (int blow = 0; blow < 20; ++blow) {
        island.error = 0.05f;  // decays within two steps
        island.follows = 0.9f;
        island.run(10);
    }
    EXPECT_EQ(island.changes, 0);
}

TEST(SubstepController, keepsTheToleranceWithoutOscillation) {
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
    island.run(60 * 60);  // the controller has learned that a lower quality is not sufficient
    const Quality high = island.effort.quality;
    ASSERT_GE(high, 3);
    island.load = 0.0001f;
    island.run(600);
    EXPECT_EQ(island.effort.quality, 0);
}

TEST(SubstepController, doesNotRaiseTheQualityWhereItDoesNotHelp) {
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
    island.load = 0.3f;  // from now on a higher quality helps
    island.run(120);
    EXPECT_LE(island.error, kTolerance);
}

TEST(SubstepController, staysBetweenTheRequestedAndTheMaximumQuality) {
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

struct Tie {
    float error = 0.0f, tolerance = 0.0f;  // m
};

/// Finds an error and a tolerance for which error * factor is exactly kRoom * tolerance.
Tie tieOf(float factor) {
    for (float tolerance = 1.0f; tolerance < 1.001f; tolerance = std::nextafter(tolerance, 2.0f)) {
        const float limit = kRoom * tolerance, error = limit / factor;
        for (const float near : {std::nextafter(error, 0.0f), error, std::nextafter(error, 9.0f)})
            if (near * factor == limit) return {near, tolerance};
    }
    ADD_FAILURE() << "no such error and tolerance found";
    return {};
}

TEST(SubstepController, limitsAreInclusive) {
    const auto after = [](SubstepController one, float error, float tolerance = 1.0f) {
        one.before = 1;
        one.quality = 2;
        return judged(one, error, tolerance, 0, kStep);
    };
    constexpr std::uint32_t kLong = 1000;  // steps
    using Phase = SubstepPhase;
    // Errors equal to the tolerance.
    for (const Phase phase : {Phase::Calm, Phase::Strained, Phase::Rising, Phase::Resigned})
        EXPECT_EQ(after({.phase = phase, .wait = kLong}, 1.0f).phase, Phase::Calm);
    EXPECT_EQ(after({.phase = Phase::Trying, .wait = kLong}, kRoom).phase, Phase::Trying);
    // Maximum error at which a lower quality is tried, and the limit of an error that another level corrects.
    const Tie small = tieOf(kMaxGain), large = tieOf(1.0f / kMinGain);
    EXPECT_EQ(after({.phase = Phase::Calm}, small.error, small.tolerance).phase, Phase::Trying);
    EXPECT_EQ(after({.phase = Phase::Rising, .error = large.error, .first = large.error}, large.error,
                    large.tolerance)
                  .phase,
              Phase::Resigned);
    // Changes of the load exactly at the thresholds count as neither growth nor shrinkage.
    EXPECT_EQ(after({.phase = Phase::Rising, .wait = kLong, .first = 10.0f}, kGrew * 10.0f).first, 10.0f);
    for (const float change : {kGrew, kHelped})
        EXPECT_EQ(after({.phase = Phase::Resigned, .wait = kLong, .error = 10.0f}, change * 10.0f).phase,
                  Phase::Resigned);
    EXPECT_EQ(after({.phase = Phase::Calm, .patience = 3, .wait = kLong, .first = 1.0f}, kVanished).patience,
              3);
}

/// Creates a random state with one of only three qualities, so that many pairs of states have equal ones.
SubstepController anyController(Random& random) {
    SubstepController one;
    one.quality = static_cast<Quality>(static_cast<int>(random.below(3)) - 1);
    one.before = static_cast<Quality>(random.below(5));
    one.phase = static_cast<SubstepPhase>(random.below(5));
    one.patience = static_cast<std::uint8_t>(random.below(5));
    one.wait = random.below(9);
    one.error = random.unit();
    one.first = random.unit();
    return one;
}

void expectSame(const SubstepController& a, const SubstepController& b) {
    EXPECT_EQ(a.quality, b.quality);
    EXPECT_EQ(a.before, b.before);
    EXPECT_EQ(a.phase, b.phase);
    EXPECT_EQ(a.patience, b.patience);
    EXPECT_EQ(a.wait, b.wait);
    EXPECT_EQ(a.error, b.error);
    EXPECT_EQ(a.first, b.first);
}

TEST(SubstepController, ofMergedIslandsIsThatOfTheHardestInAnyOrder) {
    Random random = Random::seeded(1);
    for (int i = 0; i < 1000; ++i) {
        const SubstepController a = anyController(random), b = anyController(random),
                                c = anyController(random);
        const SubstepController both = merged(a, b);
        expectSame(both, merged(b, a));
        expectSame(merged(both, c), merged(a, merged(b, c)));
        expectSame(merged(a, a), a);
        if (a.quality != b.quality) {
            expectSame(both, a.quality > b.quality ? a : b);
            continue;
        }
        EXPECT_EQ(both.quality, a.quality);
        EXPECT_EQ(both.phase, std::max(a.phase, b.phase));
        EXPECT_EQ(both.wait, std::max(a.wait, b.wait));
        EXPECT_EQ(both.error, std::max(a.error, b.error));
        EXPECT_EQ(both.first, std::max(a.first, b.first));
        EXPECT_EQ(both.patience, std::max(a.patience, b.patience));
        EXPECT_EQ(both.before, std::max(a.before, b.before));
    }
}

}  // namespace
}  // namespace plumb::physics
