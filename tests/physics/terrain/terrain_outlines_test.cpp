#include "physics/terrain/terrain_outlines.hpp"

#include <gtest/gtest.h>

#include "core/task_pool.hpp"
#include "tests/physics/support/random_terrain.hpp"
#include "tests/support/allocations.hpp"

namespace plumb::physics {
namespace {

using namespace test;

std::vector<std::uint32_t> chunksThatDiffer(const std::vector<TerrainOutline>& a,
                                            const std::vector<TerrainOutline>& b) {
    std::vector<std::uint32_t> differ;
    for (std::uint32_t i = 0; i < a.size(); ++i) {
        if (a[i] != b[i]) differ.push_back(i);
    }
    return differ;
}

TEST(TerrainOutlines, afterRandomEditsEqualARebuildAndReportTheChanges) {
    const int count = masksToTry(2000) / 5;
    for (int seed = 0; seed < count; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(static_cast<std::uint64_t>(seed) + 3'000'000);
        const int chunkCells = 4 + static_cast<int>(random.below(13));
        TileMask mask = randomMask(1 + static_cast<int>(random.below(32)),
                                   1 + static_cast<int>(random.below(32)), random);
        TerrainOutlines terrain = built(mask, chunkCells);
        RandomCells cells{terrain.palette(), random};
        for (int round = 0; round < 6; ++round) {
            const std::vector<TerrainOutline> old = terrain.chunks();
            for (std::uint32_t edits = 1 + random.below(8) * random.below(4); edits > 0; --edits) {
                terrain.set(static_cast<int>(random.below(34)) - 1, static_cast<int>(random.below(34)) - 1,
                            cells.next());
            }
            const auto changed = terrain.update();
            ASSERT_EQ(terrain.chunks(), built(terrain.mask(), chunkCells).chunks());
            ASSERT_EQ((std::vector<std::uint32_t>{changed.begin(), changed.end()}),
                      chunksThatDiffer(old, terrain.chunks()));
        }
    }
}

/// Builds a mask of uniform, empty and random chunks, as in real maps.
TileMask patchwork(int columns, int rows, Random& random, bool byChunks) {
    constexpr int kSide = TileGrid::kChunkSide;
    TileMask mask{columns * kSide - 5, rows * kSide - 9};
    RandomCells cells{mask.palette, random};
    const MaskCell plains[] = {{}, {TileForm::Full}, {TileForm::Full}, {TileForm::SlopeUp}};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            TileMask::Chunk chunk;
            const std::uint32_t kind = random.below(20);
            chunk.fill(plains[column / 6 % 4]);
            if (kind == 0) std::generate(chunk.begin(), chunk.end(), [&] { return cells.next(); });
            if (kind == 1) chunk[random.below(kSide * kSide)] = cells.next();
            if (byChunks) {
                mask.putChunk(column, row, chunk);
                continue;
            }
            for (int i = 0; i < kSide * kSide; ++i)
                mask.set(column * kSide + i % kSide, row * kSide + i / kSide,
                         chunk[static_cast<std::size_t>(i)]);
        }
    }
    return mask;
}

TEST(TerrainOutlines, areTheSameForAnyOrderOfCellsAndAnyNumberOfThreads) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        SCOPED_TRACE(seed);
        Random one = Random::seeded(seed), other = Random::seeded(seed);
        TerrainOutlines terrain{patchwork(36, 30, one, false)};
        TerrainOutlines quick{patchwork(36, 30, other, true)};
        TaskPool pool{3};
        const auto changed = terrain.update();
        const auto changedQuick = quick.update(&pool);
        ASSERT_EQ(terrain.chunks(), quick.chunks());
        ASSERT_EQ((std::vector<std::uint32_t>{changed.begin(), changed.end()}),
                  (std::vector<std::uint32_t>{changedQuick.begin(), changedQuick.end()}));
        ASSERT_GT(changed.size(), 400u);
        // A hole in a uniform chunk is detected and changes nothing else.
        const TileMask before = quick.mask();
        for (TerrainOutlines* each : {&terrain, &quick}) each->set(6 * 32 + 50, 100, {TileForm::SlopeDown});
        terrain.update(), quick.update(&pool);
        ASSERT_EQ(terrain.chunks(), quick.chunks());
        ASSERT_EQ(before.at(6 * 32 + 51, 101), quick.mask().at(6 * 32 + 51, 101));
        ASSERT_EQ(before.at(7 * 32 + 50, 100 + 64), quick.mask().at(7 * 32 + 50, 100 + 64));
    }
}

TEST(TerrainOutlines, dependOnTheChunkSizeOnlyByCuts) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const TileMask mask = randomMask(40, 40, random);
        const auto lengthOf = [](const TerrainOutlines& terrain) {
            std::int64_t length = 0;
            for (const TerrainSegment& s : allSegments(terrain)) {
                length += std::abs(s.b.x - s.a.x) + std::abs(s.b.y - s.a.y);
            }
            return length;
        };
        EXPECT_EQ(lengthOf(built(mask, 4)), lengthOf(built(mask, 128)));
    }
}

TEST(TerrainOutlines, reportNoChangeWithoutAChange) {
    TerrainOutlines terrain{drawn({"#...", "####"})};
    EXPECT_EQ(terrain.update().size(), 1u);
    EXPECT_TRUE(terrain.update().empty());
    terrain.set(0, 0, {TileForm::Full});
    EXPECT_TRUE(terrain.update().empty());
    terrain.set(2, 0, {TileForm::Full});
    terrain.set(2, 0, {});
    EXPECT_TRUE(terrain.update().empty());
    terrain.set(-1, 0, {TileForm::Full});
    EXPECT_TRUE(terrain.update().empty());
}

TEST(TerrainOutlines, reportNeighboursWhoseGhostVerticesChange) {
    TileMask mask{16, 8};
    for (int x = 0; x < 16; ++x) mask.set(x, 7, {TileForm::Full});
    TerrainOutlines terrain = built(mask, 8);

    terrain.set(12, 3, {TileForm::Full});  // far from the chunk border
    EXPECT_EQ(terrain.update().size(), 1u);
    terrain.set(8, 6, {TileForm::Full});  // a wall at the end of the first chunk's floor
    const auto changed = terrain.update();
    ASSERT_EQ((std::vector<std::uint32_t>{changed.begin(), changed.end()}),
              (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(terrain.chunks()[0].back().after, (cornerOfCell(8, 6)));
}

TEST(TerrainOutlines, ofNoCellsHaveNoChunks) {
    TerrainOutlines terrain;
    EXPECT_TRUE(terrain.update().empty());
    TerrainOutlines flat{TileMask{100, 0}};
    EXPECT_TRUE(flat.update().empty());
    flat.set(0, 0, {TileForm::Full});
    EXPECT_TRUE(flat.update().empty());
}

TEST(TerrainOutlines, areEditedWithoutNewMemory) {
    Random random = Random::seeded(5);
    TerrainOutlines terrain = built(randomMask(96, 96, random));
    const auto edit = [&](MaskCell cell) {
        terrain.set(40, 40, cell);
        terrain.set(31, 32, cell);
        terrain.update();
    };
    for (int i = 0; i < 4; ++i) edit({i % 2 == 0 ? TileForm::Full : TileForm::Empty});

    const std::size_t before = plumb::test::allocations().made;
    for (int i = 0; i < 20; ++i) edit({i % 2 == 0 ? TileForm::Full : TileForm::Empty});
    EXPECT_EQ(plumb::test::allocations().made, before);
}

}  // namespace
}  // namespace plumb::physics
