#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/accuracy/families/report.hpp"

namespace plumb::families {
namespace {

// Runs a small part of ./plumb accuracy --families, with fixed seeds.
constexpr int kMembers = 3;  // number of random scenes per family

class Families : public testing::TestWithParam<const Family*> {};

TEST_P(Families, keepEveryRelation) {
    RunOptions options;
    options.families = {GetParam()};
    options.members = kMembers;
    const std::vector<FamilyResult> results = runFamilies(options);
    ASSERT_EQ(results.size(), 1u);
    EXPECT_TRUE(results[0].holds()) << textOf(results[0]);
    EXPECT_EQ(results[0].verdicts.size(), allRelations().size());
    const auto reaches = [](const Verdict& verdict) {
        return verdict.baseReached + verdict.variedReached > 0;
    };
    EXPECT_TRUE(std::any_of(results[0].verdicts.begin(), results[0].verdicts.end(), reaches))
        << textOf(results[0]);
}

TEST_P(Families, makeTheSameMemberFromTheSameSeed) {
    const Outcome one = play(memberOf(*GetParam(), 1)), two = play(memberOf(*GetParam(), 1));
    EXPECT_EQ(one.bits, two.bits);
    EXPECT_NE(play(memberOf(*GetParam(), 2)).bits, one.bits);
}

std::vector<const Family*> pointersToFamilies() {
    std::vector<const Family*> all;
    for (const Family& family : allFamilies()) all.push_back(&family);
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(pointersToFamilies()), [](const auto& param) {
    std::string name;
    for (const char c : param.param->name) name += c == '-' ? '_' : c;
    return name;
});

/// A block that slides down a slope of 20 degrees without friction, so that its motion is known exactly.
Blueprint slidingBlock() {
    Blueprint plan;
    plan.seconds = 1.0;
    plan.addStatic(scenes::box({50.0f, 1.0f}), {}, {.friction = 0.0f}, 0.35f);
    const float sine = std::sin(0.35f), cosine = std::cos(0.35f);
    plan.addDynamic(scenes::box({0.5f, 0.5f}), {-1.5f * sine, 1.5f * cosine}, {.friction = 0.0f}, 0.35f);
    return plan;
}

TEST(Stages, resultsAreInBlueprintCoordinatesForEveryPlacement) {
    const Blueprint plan = slidingBlock();
    const Outcome usual = play(plan);
    ASSERT_GT(usual.contacts, 0u);
    const double distance = 0.5 * 10.0 * std::sin(0.35);
    EXPECT_NEAR(usual.ends[1].x, -1.5 * std::sin(0.35) - distance * std::cos(0.35), 0.02);
    for (const bool mirrored : {false, true}) {
        for (int turns = 0; turns < 4; ++turns) {
            for (const float scale : {0.125f, 1.0f, 8.0f}) {
                Variation variation;
                variation.placement = {mirrored, turns, scale, 10.0, -10.0};
                EXPECT_LT(largestDistance(play(plan, variation), usual), 1e-3)
                    << mirrored << ' ' << turns << ' ' << scale;
            }
        }
    }
}

TEST(Stages, omitDroppedBodies) {
    const Blueprint plan = slidingBlock();
    const Outcome alone = play(plan, {.dropped = {true}});
    EXPECT_EQ(alone.contacts, 0u);
    EXPECT_NEAR(alone.ends[1].y, 1.5 * std::cos(0.35) - 5.0, 0.01)
        << "without the slope the block is in free fall";
}

/// At quality 1 contacts are too soft for cards 2 cm thick, so a few houses fall; at quality 2 all stand.
TEST(CardHouses, mostStandAtQuality1) {
    int standing = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
        standing += play(memberOf(*findFamily("card-house"), seed), {.quality = 1}).reached ? 1 : 0;
    EXPECT_GE(standing, 98);
}

// Bodies that a soft body woke had contacts with the indices and keys of former ones of another island, and
// the solver took them for these.
TEST(Restoring, changesNoBitWhereSoftBodiesWakeBodies) {
    const Blueprint plan = memberOf(*findFamily("soft-among-rigid"), 272);
    EXPECT_EQ(play(plan, {.restoreEvery = 7}).bits, play(plan).bits);
}

TEST(Verdicts, failOnlyForStatisticallySignificantDifferences) {
    Verdict verdict;
    verdict.relation = findRelation("sleep");
    verdict.members = 100;
    verdict.worse = 3;
    EXPECT_TRUE(verdict.holds()) << "3 of 3 happen by chance in one of eight cases";
    verdict.worse = 12;
    EXPECT_FALSE(verdict.holds());
    verdict.better = 9;
    EXPECT_TRUE(verdict.holds());
    verdict.differing = 1;
    EXPECT_FALSE(verdict.holds()) << "a member has different final positions";
}

TEST(Shrinking, returnsNothingForARelationThatHolds) {
    const Family& family = *findFamily("card-house");
    EXPECT_TRUE(shrink(*findRelation("numbers"), family, 1).empty()) << "the relation holds";
}

}  // namespace
}  // namespace plumb::families
