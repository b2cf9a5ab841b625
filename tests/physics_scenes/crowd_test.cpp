#include "tests/bench/physics/crowd.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace plumb::scenes {
namespace {

using physics::BroadPhaseKind;
using physics::PairKey;

TEST(Crowd, everyBroadPhaseFindsTheSamePairsInEach) {
    constexpr auto kKinds = static_cast<std::uint32_t>(BroadPhaseKind::Count);
    for (const CrowdKind& kind : crowdKinds()) {
        SCOPED_TRACE(kind.name);
        std::vector<PairKey> expected;
        for (std::uint32_t i = 0; i < kKinds; ++i) {
            const auto phase = physics::makeBroadPhase(static_cast<BroadPhaseKind>(i));
            Crowd crowd = kind.make(1500);
            phase->rebuild(crowd.proxies());
            std::vector<PairKey> all;
            for (int step = 0; step < 40; ++step) {
                crowd.step();
                phase->update(crowd.proxies(), crowd.changed());
                std::vector<std::uint32_t> moved{crowd.moved().begin(), crowd.moved().end()};
                phase->arrange(moved);
                std::vector<PairKey> pairs;
                phase->findPairs(moved, crowd.isMoved(), pairs);
                std::sort(pairs.begin(), pairs.end());
                all.insert(all.end(), pairs.begin(), pairs.end());
            }
            if (i == 0) expected = all;
            EXPECT_FALSE(all.empty());
            EXPECT_EQ(all, expected);
        }
    }
}

TEST(Crowd, movesAccordingToItsName) {
    const auto movedIn = [](std::string_view name) {
        for (const CrowdKind& kind : crowdKinds()) {
            if (kind.name != name) continue;
            Crowd crowd = kind.make(1000);
            std::size_t moved = 0;
            for (int step = 0; step < 10; ++step) {
                crowd.step();
                moved += crowd.moved().size();
            }
            return moved;
        }
        return std::size_t{0};
    };
    EXPECT_EQ(movedIn("all fast"), 10000u);
    EXPECT_GT(movedIn("uniform"), 2000u);
    EXPECT_GT(movedIn("mostly still"), 50u);
    EXPECT_LT(movedIn("mostly still"), 200u);
}

}  // namespace
}  // namespace plumb::scenes
