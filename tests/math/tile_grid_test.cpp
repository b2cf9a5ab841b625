#include "math/tile_grid.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

TEST(TileGrids, matchAPlainArray) {
    Random random = Random::seeded(7);
    constexpr int kWidth = 70;
    constexpr int kHeight = 45;
    TileGrid grid{kWidth, kHeight};
    std::vector<TileCell> plain(kWidth * kHeight);
    for (int i = 0; i < 20000; ++i) {
        const int x = static_cast<int>(random.below(kWidth + 4)) - 2;
        const int y = static_cast<int>(random.below(kHeight + 4)) - 2;
        const TileCell cell = random.below(3);
        grid.set(x, y, cell);
        if (grid.has(x, y)) plain[static_cast<std::size_t>(y * kWidth + x)] = cell;
    }
    EXPECT_EQ(grid.cells(), plain);
    TileGrid copy;
    copy.replaceCells(kWidth, kHeight, plain);
    EXPECT_EQ(copy, grid);
    EXPECT_EQ(grid.at(-1, 0), 0u);
    EXPECT_EQ(grid.at(kWidth, 0), 0u);
}

TEST(TileGrids, aCopyKeepsItsCellsWhenTheOriginalChanges) {
    TileGrid grid{40, 40};
    grid.set(3, 3, 5);
    const TileGrid copy = grid;
    grid.set(3, 3, 6);
    grid.set(39, 39, 1);
    EXPECT_EQ(copy.at(3, 3), 5u);
    EXPECT_EQ(copy.at(39, 39), 0u);
    EXPECT_EQ(grid.at(3, 3), 6u);
}

TEST(TileGrids, stampsIdentifyChangedRowsOfChunks) {
    TileGrid grid{100, 100};
    const std::uint64_t first = grid.rowStamp(0);
    const std::uint64_t second = grid.rowStamp(1);
    grid.set(50, 40, 1);
    EXPECT_EQ(grid.rowStamp(0), first);
    EXPECT_NE(grid.rowStamp(1), second);
    const std::uint64_t changed = grid.rowStamp(1);
    grid.set(50, 40, 1);
    EXPECT_EQ(grid.rowStamp(1), changed) << "the same cell again is no change";
}

TEST(TileGrids, emptyAndClearedPartsAreEqual) {
    TileGrid touched{64, 64};
    touched.set(10, 10, 4);
    touched.set(10, 10, 0);
    EXPECT_EQ(touched, (TileGrid{64, 64}));
    EXPECT_NE(touched, (TileGrid{64, 63}));
}

TEST(TileGrids, aFilledChunkIsSharedAndEndsAtTheBorder) {
    TileGrid grid{40, 64};
    const auto plain = TileGrid::filled(9);
    grid.put(0, 0, plain);
    grid.put(0, 1, plain);
    grid.put(1, 0, plain);
    EXPECT_EQ(grid.chunk(0, 0), grid.chunk(0, 1));
    EXPECT_EQ(grid.chunk(1, 0)->at(39, 0), 9u);
    EXPECT_EQ(grid.chunk(1, 0)->at(40, 0), 0u) << "nothing lies beyond the border";
    grid.set(0, 0, 1);
    EXPECT_EQ(grid.at(0, 32), 9u) << "a change of one place is seen nowhere else";
}

}  // namespace
}  // namespace plumb
