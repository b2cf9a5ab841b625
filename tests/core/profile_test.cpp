#include "core/profile.hpp"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Profiles, sumTimesAndCallsPerZoneInTheOrderOfTheirFirstUse) {
    Profile profile;
    profile.add("physics", 0.5);
    profile.add("render", 0.125);
    profile.add("physics", 0.25);
    ASSERT_EQ(profile.zones().size(), 2u);
    EXPECT_EQ(profile.zones()[0].name, "physics");
    EXPECT_EQ(profile.zones()[0].seconds, 0.75);
    EXPECT_EQ(profile.zones()[0].calls, 2);
    EXPECT_EQ(profile.zones()[1].name, "render");
    EXPECT_EQ(profile.zones()[1].seconds, 0.125);
    EXPECT_EQ(profile.zones()[1].calls, 1);
}

TEST(Profiles, addTheDifferenceOfThreadTimes) {
    Profile profile;
    const TaskPool::Times start{2.0, {1.0, 0.5}}, middle{3.0, {1.25, 1.0}}, end{7.0, {4.0, 2.0}};
    profile.addThreads("physics", start, middle);
    EXPECT_EQ(profile.zones()[0].rounds, 1.0);
    EXPECT_EQ(profile.zones()[0].busy, (std::vector<double>{0.25, 0.5}));
    profile.addThreads("physics", middle, end);
    ASSERT_EQ(profile.zones().size(), 1u);
    EXPECT_EQ(profile.zones()[0].rounds, 5.0);
    EXPECT_EQ(profile.zones()[0].busy, (std::vector<double>{3.0, 1.5}));
    EXPECT_EQ(profile.zones()[0].calls, 0) << "calls are counted by add()";
}

TEST(Profiles, areEmptyAfterAResetAndKeepTheirZones) {
    Profile profile;
    profile.add("physics", 0.5);
    profile.addThreads("physics", {0.0, {0.0, 0.0}}, {1.0, {1.0, 1.0}});
    profile.reset();
    ASSERT_EQ(profile.zones().size(), 1u);
    EXPECT_EQ(profile.zones()[0].seconds, 0.0);
    EXPECT_EQ(profile.zones()[0].calls, 0);
    EXPECT_EQ(profile.zones()[0].rounds, 0.0);
    EXPECT_EQ(profile.zones()[0].busy, (std::vector<double>{0.0, 0.0}));
}

TEST(Profiles, aScopeAddsItsOwnTimeUnlessTheProfileIsOffOrNull) {
    Profile profile;
    const double start = threadSeconds();
    {
        const ProfileScope scope{&profile, "work"};
        while (threadSeconds() - start < 2e-3) {
        }
    }
    const double end = threadSeconds();
    ASSERT_EQ(profile.zones().size(), 1u);
    EXPECT_EQ(profile.zones()[0].calls, 1);
    EXPECT_LE(profile.zones()[0].seconds, end - start);
    EXPECT_GE(profile.zones()[0].seconds, 1e-3);
    profile.on = false;
    { const ProfileScope scope{&profile, "other"}; }
    { const ProfileScope scope{nullptr, "other"}; }
    EXPECT_EQ(profile.zones().size(), 1u);
}

}  // namespace
}  // namespace plumb
