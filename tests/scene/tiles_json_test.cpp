#include "scene/tiles_json.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reflect/json.hpp"

namespace plumb {
namespace {

TEST(TilesJson, aLargeMapKeepsItsCellsInBlocks) {
    Random random = Random::seeded(3);
    TileGrid grid{700, 300};
    for (int i = 0; i < 4000; ++i)
        grid.set(static_cast<int>(random.below(200)), static_cast<int>(random.below(300)), random.next());
    for (int y = 128; y < 256; ++y) {
        for (int x = 256; x < 384; ++x) grid.set(x, y, cellOf(6, kTileFlipX));
    }
    grid.set(699, 299, 5);
    const Json json = tilesToJson(grid);
    const Result<ReadTiles> read = tilesFromJson(json);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->grid, grid);
    EXPECT_EQ(tilesToJson(read->grid), json) << "writing again changes nothing";
}

TEST(TilesJson, aChangedTileChangesOneLine) {
    TileGrid grid{600, 600};
    for (int i = 0; i < 600; ++i) grid.set(i, i, 3);
    Json before = tilesToJson(grid)["blocks"];
    grid.set(400, 400, 9);
    Json after = tilesToJson(grid)["blocks"];
    ASSERT_EQ(before.size(), after.size());
    int changed = 0;
    for (std::size_t i = 0; i < before.size(); ++i) changed += before[i] == after[i] ? 0 : 1;
    EXPECT_EQ(changed, 1);
}

TEST(TilesJson, emptyAndPlainPartsOfAHugeMapTakeAlmostNothing) {
    TileGrid grid{16384, 16384};
    const auto plain = TileGrid::filled(7);
    for (int row = 256; row < grid.chunkRows(); ++row) {
        for (int column = 0; column < grid.chunkColumns(); ++column) grid.put(column, row, plain);
    }
    const Json json = tilesToJson(grid);
    EXPECT_EQ(json["blocks"].size(), 128u * 64u);
    EXPECT_EQ(json["blocks"][0], "0 64 =7");
    const Result<ReadTiles> read = tilesFromJson(json);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->grid.at(0, 8191), 0u);
    EXPECT_EQ(read->grid.at(16383, 16383), 7u);
}

TEST(TilesJson, damagedBlocksAreToldWithTheirPlace) {
    for (const char* text :
         {"0 0", "9 0 =1", "0 -1 =1", "0 0 =", "0 0 =1 2", "0 0 eNrtnoise", "x 0 =1", ""}) {
        Json json = Json::object();
        json["width"] = 300;
        json["height"] = 300;
        json["blocks"] = Json::array({"1 0 =1", text});
        const Result<ReadTiles> read = tilesFromJson(json);
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_EQ(read.error().where, "blocks[1]");
    }
}

}  // namespace
}  // namespace plumb
