#include "scene/files/tiles_json.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "codec/base64.hpp"
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
    EXPECT_EQ(tilesToJson(read->grid), json) << "writing a read grid again gives the same JSON";
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

/// Returns the checksum at the end of a zlib stream (RFC 1950, Adler-32), highest byte first.
std::string checksumOf(const std::string& bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    std::string sum;
    for (int shift = 24; shift >= 0; shift -= 8) sum += static_cast<char>((b << 16 | a) >> shift & 255u);
    return sum;
}

/// Returns the text of a block as written by a zlib packer that only stores bytes.
std::string packedByOthers(const TileGrid& grid, int side) {
    std::string bytes;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            for (int shift = 0; shift < 32; shift += 8)
                bytes += static_cast<char>(grid.at(x, y) >> shift & 255u);
        }
    }
    std::string packed = "\x78\x01";
    for (std::size_t at = 0; at < bytes.size(); at += 32768) {
        const std::size_t count = std::min<std::size_t>(32768, bytes.size() - at);
        packed += at + count == bytes.size() ? '\1' : '\0';
        for (const std::size_t half : {count, ~count}) {
            packed += static_cast<char>(half & 255u);
            packed += static_cast<char>(half >> 8 & 255u);
        }
        packed.append(bytes, at, count);
    }
    return "0 0 " + toBase64(packed + checksumOf(bytes));
}

TEST(TilesJson, aBlockOfAnotherPackerIsKeptUntilItsTilesChange) {
    TileGrid grid{300, 300};
    for (int i = 0; i < 300; ++i) grid.set(i, i, cellOf(i));
    Json json = tilesToJson(grid);
    const std::string theirs = packedByOthers(grid, 128);
    ASSERT_NE(json["blocks"][0], theirs);
    json["blocks"][0] = theirs;
    Result<ReadTiles> read = tilesFromJson(json);
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read->grid, grid);
    EXPECT_EQ(tilesToJson(read->grid), json);
    const TileGrid copy = read->grid;
    read->grid.set(5, 6, 9);
    EXPECT_NE(tilesToJson(read->grid)["blocks"][0], theirs);
    EXPECT_EQ(tilesToJson(copy), json) << "an unchanged copy keeps the file's blocks";
    EXPECT_EQ(tilesFromJson(tilesToJson(read->grid))->grid, read->grid);
    read->grid.set(5, 6, 0);
    EXPECT_EQ(tilesFromJson(tilesToJson(read->grid))->grid, grid);
}

TEST(TilesJson, emptyAndUniformPartsOfAHugeMapAreSmall) {
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

TEST(TilesJson, damagedBlocksAreReportedWithTheirPosition) {
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
