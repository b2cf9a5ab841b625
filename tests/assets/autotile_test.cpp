#include "assets/autotile.hpp"

#include <map>

#include <gtest/gtest.h>

namespace plumb {
namespace {

/// Returns a tileset with one terrain whose tiles 0, 1, 2 ... have the masks of a mode in ascending order.
Tileset setOf(TerrainMode mode) {
    Tileset set;
    set.count = 100;
    Terrain terrain;
    terrain.mode = mode;
    for (const std::uint8_t mask : masksOf(mode))
        terrain.tiles.push_back({static_cast<int>(terrain.tiles.size()), mask});
    set.terrains = {terrain};
    return set;
}

int tileOfMask(const Tileset& set, int mask) {
    for (const TerrainTile& tile : set.terrains.front().tiles) {
        if (int{tile.mask} == mask) return tile.tile;
    }
    return -1;
}

TEST(Autotiles, eachModeHasTheExpectedNumberOfDistinctMasks) {
    EXPECT_EQ(masksOf(TerrainMode::Edges).size(), 16u);
    EXPECT_EQ(masksOf(TerrainMode::Blob).size(), 47u);
    EXPECT_EQ(masksOf(TerrainMode::Corners).size(), 16u);
}

TEST(Autotiles, aCornerCountsInABlobOnlyIfBothAdjacentEdgesDo) {
    using N = Neighbour;
    EXPECT_EQ(countedMask(TerrainMode::Blob, N::kUpRight), 0);
    EXPECT_EQ(countedMask(TerrainMode::Blob, N::kUp | N::kUpRight), N::kUp);
    EXPECT_EQ(countedMask(TerrainMode::Blob, N::kUp | N::kRight | N::kUpRight),
              N::kUp | N::kRight | N::kUpRight);
}

TEST(Autotiles, aCellGetsTheTileThatMatchesItsNeighbours) {
    const Tileset set = setOf(TerrainMode::Edges);
    const Autotile autotile{set};
    TileGrid terrain{5, 5};
    for (const auto& [x, y] : {std::pair{2, 2}, std::pair{2, 1}, std::pair{3, 2}}) terrain.set(x, y, 1);
    EXPECT_EQ(autotile.cellAt(terrain, 2, 2), cellOf(tileOfMask(set, Neighbour::kUp | Neighbour::kRight)));
    EXPECT_EQ(autotile.cellAt(terrain, 2, 1), cellOf(tileOfMask(set, Neighbour::kDown)));
    EXPECT_EQ(autotile.cellAt(terrain, 0, 0), std::nullopt) << "no terrain decides there";
}

TEST(Autotiles, terrainContinuesBeyondTheBorderOfTheLayer) {
    const Tileset set = setOf(TerrainMode::Blob);
    TileGrid terrain{3, 3};
    for (int i = 0; i < 9; ++i) terrain.set(i % 3, i / 3, 1);
    for (int i = 0; i < 9; ++i)
        EXPECT_EQ(Autotile{set}.cellAt(terrain, i % 3, i / 3), cellOf(tileOfMask(set, Neighbour::kAll)));
}

TEST(Autotiles, aCornerDeterminesTheFourCellsAroundIt) {
    const Tileset set = setOf(TerrainMode::Corners);
    const Autotile autotile{set};
    TileGrid terrain{6, 6};
    terrain.set(3, 3, 1);
    EXPECT_EQ(autotile.cellAt(terrain, 3, 3), cellOf(tileOfMask(set, Neighbour::kUpLeft)));
    EXPECT_EQ(autotile.cellAt(terrain, 2, 3), cellOf(tileOfMask(set, Neighbour::kUpRight)));
    EXPECT_EQ(autotile.cellAt(terrain, 3, 2), cellOf(tileOfMask(set, Neighbour::kDownLeft)));
    EXPECT_EQ(autotile.cellAt(terrain, 2, 2), cellOf(tileOfMask(set, Neighbour::kDownRight)));
    EXPECT_EQ(autotile.cellAt(terrain, 1, 1), std::nullopt);
}

TEST(Autotiles, aMaskWithoutATileUsesTheMostSimilarMask) {
    Tileset set;
    set.count = 10;
    Terrain terrain;
    terrain.tiles = {{4, Neighbour::kAll}, {5, 0}};
    set.terrains = {terrain};
    TileGrid ground{5, 5};
    for (int i = 0; i < 25; ++i) ground.set(i % 5, i / 5, 1);
    ground.set(2, 1, 0);
    EXPECT_EQ(Autotile{set}.cellAt(ground, 2, 2), cellOf(4)) << "one side is missing only";
}

TEST(Autotiles, variantsFollowTheirProbabilityAndDependOnlyOnThePosition) {
    Tileset set;
    set.count = 10;
    Terrain terrain;
    terrain.tiles = {{0, Neighbour::kAll}, {1, Neighbour::kAll}, {2, Neighbour::kAll}};
    set.terrains = {terrain};
    Tile rare;
    rare.id = 1;
    rare.probability = 0.25f;
    Tile never;
    never.id = 2;
    never.probability = 0.0f;
    set.tiles = {rare, never};
    const Autotile autotile{set};
    TileGrid ground{100, 100};
    std::map<TileCell, int> seen;
    for (int i = 0; i < 10000; ++i) ground.set(i % 100, i / 100, 1);
    for (int i = 0; i < 10000; ++i) {
        const auto cell = autotile.cellAt(ground, i % 100, i / 100);
        ++seen[*cell];
        EXPECT_EQ(autotile.cellAt(ground, i % 100, i / 100), cell);
    }
    EXPECT_NEAR(seen[cellOf(0)], 8000, 200);
    EXPECT_NEAR(seen[cellOf(1)], 2000, 200);
    EXPECT_EQ(seen[cellOf(2)], 0);
}

TEST(Autotiles, terrainIsDeterminedFromTheTilesOfAMap) {
    for (const TerrainMode mode : {TerrainMode::Edges, TerrainMode::Blob, TerrainMode::Corners}) {
        const Tileset set = setOf(mode);
        const Autotile autotile{set};
        TileGrid terrain{20, 20};
        for (int i = 0; i < 400; ++i) {
            if (i * 7919 % 5 < 2) terrain.set(i % 20, i / 20, 1);
        }
        TileGrid cells{20, 20};
        for (int i = 0; i < 400; ++i)
            cells.set(i % 20, i / 20, autotile.cellAt(terrain, i % 20, i / 20).value_or(0));
        EXPECT_EQ(terrainFromTiles(cells, set), terrain);
    }
}

}  // namespace
}  // namespace plumb
