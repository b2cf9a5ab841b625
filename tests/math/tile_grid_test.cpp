#include "math/tile_grid.hpp"

#include <algorithm>
#include <utility>
#include <vector>

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

struct Model {
    int width, height;
    std::vector<TileCell> cells;

    [[nodiscard]] bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    TileCell& cell(int x, int y) { return cells[static_cast<std::size_t>(y * width + x)]; }
    TileCell at(int x, int y) { return has(x, y) ? cell(x, y) : 0; }
};

TEST(TileGridProperty, anyChangesEqualThoseOfAPlainArray) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const auto below = [&](int count) {
            return static_cast<int>(random.below(static_cast<unsigned>(count)));
        };
        Model model{1 + below(100), 1 + below(80), {}};
        if (seed % 3 == 0) model.width = 64, model.height = 32;  // whole chunks
        model.cells.resize(static_cast<std::size_t>(model.width * model.height));
        TileGrid grid{model.width, model.height};
        const int columns = (model.width + 31) / 32, rows = (model.height + 31) / 32;
        ASSERT_EQ(grid.chunkColumns(), columns);
        ASSERT_EQ(grid.chunkRows(), rows);
        for (int step = 0; step < 40; ++step) {
            const TileGrid before = grid;
            if (below(3) == 0) {  // a chunk of equal cells
                const int column = below(columns), row = below(rows);
                const TileCell cell = random.below(3);
                grid.put(column, row, TileGrid::filled(cell));
                for (int y = row * 32; y < row * 32 + 32; ++y) {
                    for (int x = column * 32; x < column * 32 + 32; ++x) {
                        if (model.has(x, y)) model.cell(x, y) = cell;
                    }
                }
            } else {
                const int x = below(model.width + 4) - 2, y = below(model.height + 4) - 2;
                const TileCell cell = random.below(3);
                grid.set(x, y, cell);
                if (model.has(x, y)) model.cell(x, y) = cell;
            }
            ASSERT_EQ(grid == before, grid.cells() == before.cells());
            const int x = below(model.width + 80) - 40, y = below(model.height + 4) - 2;
            std::vector<TileCell> row(random.below(150)), expected(row.size());
            grid.copyRow(x, y, row.size(), row.data());
            for (std::size_t i = 0; i < row.size(); ++i) expected[i] = model.at(x + static_cast<int>(i), y);
            ASSERT_EQ(row, expected) << x << " " << y;
        }
        ASSERT_EQ(grid.cells(), model.cells);
        for (int y = -1; y <= rows * 32; ++y) {
            for (int x = -1; x <= columns * 32; ++x)
                ASSERT_EQ(grid.at(x, y), model.at(x, y)) << x << " " << y;
        }
        for (int y = 0; y < rows * 32; ++y) {
            for (int x = 0; x < columns * 32; ++x) {
                const TileGrid::Chunk* chunk = grid.chunk(x / 32, y / 32);
                ASSERT_EQ(chunk == nullptr ? 0 : chunk->at(x, y), model.at(x, y)) << "cells of chunks";
            }
        }
        TileGrid copy;
        copy.set(0, 0, 1);
        copy.replaceCells(model.width, model.height, model.cells);
        ASSERT_EQ(copy.cells(), model.cells);
        ASSERT_EQ(copy, grid);
    }
}

TEST(TileGrids, withoutAnySideAreEmpty) {
    for (const auto& [width, height] : {std::pair{0, 0}, {0, 5}, {5, 0}, {-3, 5}, {5, -3}}) {
        TileGrid grid{width, height};
        EXPECT_EQ(grid.cellCount(), 0u);
        EXPECT_EQ(grid.width(), std::max(width, 0));
        EXPECT_EQ(grid.height(), std::max(height, 0));
        EXPECT_EQ(grid.chunkColumns(), width > 0 ? 1 : 0);
        EXPECT_EQ(grid.chunkRows(), height > 0 ? 1 : 0);
        grid.set(0, 0, 1);
        EXPECT_TRUE(grid.cells().empty());
    }
}

TEST(TileGrids, areUnequalIfAnyCellDiffers) {
    TileGrid empty{70, 70}, one{70, 70}, other{70, 70};
    one.set(69, 69, 1);
    other.set(69, 69, 2);
    EXPECT_FALSE(empty == one);
    EXPECT_FALSE(one == empty);
    EXPECT_FALSE(one == other);
    other.set(69, 69, 1);
    EXPECT_TRUE(one == other);
    EXPECT_FALSE((TileGrid{70, 70} == TileGrid{69, 70}));
    EXPECT_FALSE((TileGrid{70, 70} == TileGrid{70, 69}));
}

TEST(TileGrids, versionAndStampsChangeWithEveryChangeAndOnlyThen) {
    TileGrid grid{100, 100};
    std::uint32_t version = grid.version();
    std::vector<std::uint64_t> stamps;
    for (int row = 0; row < grid.chunkRows(); ++row) stamps.push_back(grid.rowStamp(row));
    const auto expectChange = [&](int row) {  // -1: none
        EXPECT_EQ(grid.version(), row < 0 ? version : version + 1);
        version = grid.version();
        for (int i = 0; i < grid.chunkRows(); ++i) {
            const std::uint64_t now = grid.rowStamp(i);
            EXPECT_EQ(now != std::exchange(stamps[static_cast<std::size_t>(i)], now), i == row) << i;
        }
    };
    grid.set(40, 70, 0);
    expectChange(-1);
    grid.set(100, 70, 1);
    expectChange(-1);
    grid.set(40, 70, 1);
    expectChange(2);
    const std::uint64_t chunkStamp = grid.chunk(1, 2)->stamp;
    EXPECT_EQ(chunkStamp, grid.rowStamp(2));
    grid.set(40, 70, 1);
    expectChange(-1);
    grid.set(40, 70, 2);
    expectChange(2);
    EXPECT_NE(grid.chunk(1, 2)->stamp, chunkStamp);
    const auto filled = TileGrid::filled(3);
    grid.put(0, 1, filled);
    expectChange(1);
    EXPECT_EQ(grid.chunk(0, 1), filled.get()) << "a whole chunk is shared";
    EXPECT_EQ(grid.chunk(0, 1)->stamp, filled->stamp);
    grid.put(3, 1, filled);
    expectChange(1);
    EXPECT_NE(grid.chunk(3, 1), filled.get()) << "a chunk at the border is cut";
    EXPECT_NE(grid.chunk(3, 1)->stamp, filled->stamp) << "it has other cells";
    grid.put(0, 1, nullptr);
    expectChange(1);
    EXPECT_EQ(TileGrid::filled(0), nullptr);
    EXPECT_NE(TileGrid::filled(3)->stamp, TileGrid::filled(3)->stamp);
    grid.replaceCells(40, 40, std::vector<TileCell>(1600, 7));
    EXPECT_EQ(grid.version(), version + 1);
    EXPECT_EQ(grid.width(), 40);
    EXPECT_NE(grid.chunk(0, 0)->stamp, grid.chunk(1, 0)->stamp);
}

TEST(TileGrids, aChunkThatIsNotSharedIsChangedInPlace) {
    TileGrid grid{40, 40};
    grid.set(1, 1, 1);
    const TileGrid::Chunk* chunk = grid.chunk(0, 0);
    grid.set(2, 1, 1);
    EXPECT_EQ(grid.chunk(0, 0), chunk);
    const TileGrid copy = grid;
    EXPECT_EQ(copy.chunk(0, 0), chunk) << "copies share it";
    grid.set(3, 1, 1);
    EXPECT_NE(grid.chunk(0, 0), chunk);
    EXPECT_EQ(copy.at(3, 1), 0u);
}

TEST(TileGrids, adoptAChunkWithTheStampOfItsRow) {
    TileGrid from{100, 100}, grid{100, 100};
    from.set(70, 40, 5);
    const std::uint32_t version = grid.version();
    const std::uint64_t first = grid.rowStamp(0);
    grid.adopt(from, 2, 1);
    EXPECT_EQ(grid.at(70, 40), 5u);
    EXPECT_EQ(grid, from);
    EXPECT_EQ(grid.chunk(2, 1), from.chunk(2, 1));
    EXPECT_EQ(grid.rowStamp(1), from.rowStamp(1));
    EXPECT_EQ(grid.rowStamp(0), first);
    EXPECT_EQ(grid.version(), version + 1);
}

TEST(TileGrids, replacedCellsTakeNoMemoryWhereTheyAreEmpty) {
    std::vector<TileCell> cells(70 * 40);
    cells[35 * 70 + 69] = 4;  // in the last chunk
    TileGrid grid;
    grid.replaceCells(70, 40, cells);
    EXPECT_EQ(grid.chunk(0, 0), nullptr);
    EXPECT_EQ(grid.chunk(1, 1), nullptr);
    ASSERT_NE(grid.chunk(2, 1), nullptr);
    EXPECT_EQ(grid.chunk(2, 1)->at(69, 35), 4u);
    EXPECT_EQ(grid.cells(), cells);
}

}  // namespace
}  // namespace plumb
