#include "render/draw_order.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

TEST(DrawOrder, sortsAsAStableSortWould) {
    DrawOrder order;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random{seed};
        std::vector<DrawItem> items(static_cast<std::size_t>(random.below(3000)));
        // Few different values for each part of the key, so that many keys are equal.
        for (std::uint32_t i = 0; i < items.size(); ++i) {
            items[i] = {drawKey(static_cast<int>(random.below(7)) - 3, random.below(40), random.below(3)), i};
        }
        const std::span<const DrawItem> sorted = order.sort(items);
        std::stable_sort(items.begin(), items.end(), [](DrawItem a, DrawItem b) { return a.key < b.key; });
        EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), items.begin(), items.end()));
    }
}

TEST(DrawOrder, keysOrderByLayerThenYThenGroup) {
    EXPECT_LT(drawKey(-1, 65535, 31), drawKey(0, 0, 0));
    EXPECT_LT(drawKey(0, 5, 31), drawKey(0, 6, 0));
    EXPECT_LT(drawKey(0, 5, 3), drawKey(0, 5, 4));
}

TEST(DrawOrder, layersOutOfRangeAreClamped) {
    EXPECT_EQ(drawKey(-1000000, 0, 0), drawKey(kLowestLayer, 0, 0));
    EXPECT_EQ(drawKey(1000000, 0, 0), drawKey(kHighestLayer, 0, 0));
    EXPECT_LT(drawKey(kLowestLayer, 0, 0), drawKey(kHighestLayer, 0, 0));
}

TEST(DrawOrder, sortingAnEmptyListReturnsAnEmptyList) {
    DrawOrder order;
    EXPECT_TRUE(order.sort({}).empty());
}

}  // namespace
}  // namespace plumb
