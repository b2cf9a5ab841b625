#include "assets/tileset.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"
#include "math/vec2.hpp"
#include "tests/support/damage.hpp"

namespace plumb {
namespace {

constexpr std::string_view kFull = R"({
  "format": 1,
  "image": "assets/tiles.png",
  "tileSize": [16, 8],
  "margin": 1,
  "spacing": 2,
  "columns": 4,
  "count": 16,
  "images": [{"tile": 7, "image": "assets/tree.png", "source": [1, 2, 30, 40]}],
  "offset": [0, -4],
  "tiles": [
    {
      "id": 1,
      "collision": "full",
      "material": "ice",
      "properties": {"hazard": true, "damage": 2, "sound": "assets/ouch.wav"}
    },
    {"id": 2, "collision": [[[0, 0], [4, 0], [4, 8]], [[8, 0], [16, 0], [10, 2], [8, 8]]]},
    {
      "id": 3,
      "collision": [[0, 0], [16, 0], [8, 8]],
      "oneWay": true,
      "friction": 0.02,
      "bounciness": 0.5,
      "animation": [{"tile": 3, "seconds": 0.1}, {"tile": 4, "seconds": 0.2}]
    }
  ],
  "properties": {"author": "CC0"}
}
)";

Tileset parsed(std::string_view text, std::vector<Error>& problems) {
    const Result<Tileset> result = parseTileset(text, "cave.tileset.json", problems);
    EXPECT_TRUE(result.ok()) << text;
    return result.ok() ? *result : Tileset{};
}

TEST(Tileset, everyPropertyIsReadAndWrittenBackByteForByte) {
    std::vector<Error> problems;
    const Tileset tileset = parsed(kFull, problems);

    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(writeTileset(tileset), kFull);
    EXPECT_EQ(tileset.shapeOf(1), TileShape::Full);
    EXPECT_EQ(tileset.shapeOf(2), TileShape::Polygon);
    EXPECT_EQ(tileset.find(2)->polygons.size(), 2u);
    EXPECT_EQ(tileset.shapeOf(4), TileShape::None);
    EXPECT_EQ(tileset.shapeOf(3), TileShape::Polygon);
    EXPECT_TRUE(tileset.find(1)->hasFlag("hazard"));
    EXPECT_EQ(tileset.find(1)->property("damage"), "2");
    EXPECT_EQ(tileset.imageOf(7)->path, "assets/tree.png");
    EXPECT_EQ(tileset.texture.path, textId("assets/tiles.png"));
}

TEST(Tileset, tilesLieInRowsBetweenMarginAndSpacing) {
    std::vector<Error> problems;
    const Tileset tileset = parsed(kFull, problems);

    EXPECT_EQ(tileset.sourceOf(0), (Rect{1, 1, 16, 8}));
    EXPECT_EQ(tileset.sourceOf(6), (Rect{1 + 2 * 18, 1 + 10, 16, 8}));
}

TEST(Tileset, anAnimatedTileShowsItsFramesInSequence) {
    std::vector<Error> problems;
    const Tileset tileset = parsed(kFull, problems);

    EXPECT_EQ(tileset.shownTile(3, 0.0), 3);
    EXPECT_EQ(tileset.shownTile(3, 0.15), 4);
    EXPECT_EQ(tileset.shownTile(3, 0.31), 3);
    EXPECT_EQ(tileset.shownTile(3, 3000.15), 4);
    EXPECT_EQ(tileset.shownTile(3, -1.0), 3);
    EXPECT_EQ(tileset.shownTile(5, 1.0), 5);
}

TEST(Tileset, outlinesAreClockwiseAndSlopesMeetAtTheirEdges) {
    const Vec2 size{16, 16};
    for (std::size_t i = 1; i < tileShapeNames().size(); ++i) {
        Tile tile;
        tile.shape = static_cast<TileShape>(i);
        const std::vector<std::vector<Vec2>> outlines = outlinesOf(tile, size);
        ASSERT_EQ(outlines.size(), 1u);
        const std::vector<Vec2>& points = outlines.front();
        ASSERT_GE(points.size(), 3u);
        float area = 0.0f;
        for (std::size_t k = 0; k < points.size(); ++k)
            area += cross(points[k], points[(k + 1) % points.size()]);
        EXPECT_GT(area, 0.0f) << tileShapeNames()[i];
    }
    Tile low;
    low.shape = TileShape::SlopeUpLow;
    Tile high;
    high.shape = TileShape::SlopeUpHigh;
    EXPECT_EQ(outlinesOf(low, size)[0].front(), (Vec2{16, 8}));
    EXPECT_EQ(outlinesOf(high, size)[0].front(), (Vec2{0, 8}));
    EXPECT_EQ(outlinesOf(high, size)[0][1], (Vec2{16, 0}));
}

TEST(Tileset, unknownPropertiesAreReportedAndWrittenBack) {
    std::vector<Error> problems;
    const Tileset tileset = parsed(
        R"({"format": 1, "colums": 3, "future": {"a": [1, 2]}, "tiles": [{"id": 0, "glow": 3}]})", problems);

    ASSERT_EQ(problems.size(), 3u);
    EXPECT_EQ(problems[1].remedy, "did you mean \"columns\"?");
    const std::string text = writeTileset(tileset);
    EXPECT_NE(text.find("\"future\""), std::string::npos);
    EXPECT_NE(text.find("\"glow\": 3"), std::string::npos);
    EXPECT_NE(text.find("\"colums\": 3"), std::string::npos);
}

TEST(Tileset, invalidPartsAreReportedAndIgnored) {
    const std::string_view wrong[] = {R"({"tileSize": [0, 16]})",
                                      R"({"tileSize": "16"})",
                                      R"({"tileSize": [1e30, 1]})",
                                      R"({"columns": 0})",
                                      R"({"count": -1})",
                                      R"({"count": 1e9})",
                                      R"({"margin": 0.5})",
                                      R"({"image": 7})",
                                      R"({"tiles": {}})",
                                      R"({"tiles": [3]})",
                                      R"({"tiles": [{"id": 1, "collision": "fulll"}]})",
                                      R"({"tiles": [{"id": 1, "collision": [[0, 0], [1, 1]]}]})",
                                      R"({"tiles": [{"id": 1, "collision": [[0, 0], [1, "x"], [2, 2]]}]})",
                                      R"({"tiles": [{"id": -4}]})",
                                      R"({"tiles": [{"id": 1}, {"id": 1}]})",
                                      R"({"tiles": [{"id": 1, "animation": [{"tile": 0, "seconds": 0}]}]})",
                                      R"({"tiles": [{"id": 1, "properties": []}]})",
                                      R"({"tiles": [{"id": 1, "friction": -3}]})",
                                      R"({"images": [{"tile": 1, "image": "a.png", "source": [1]}]})",
                                      R"({"offset": [1]})",
                                      R"({"format": "1"})"};
    for (const std::string_view text : wrong) {
        std::vector<Error> problems;
        const Tileset tileset = parsed(text, problems);
        ASSERT_EQ(problems.size(), 1u) << text;
        EXPECT_FALSE(problems[0].where.empty());
        EXPECT_FALSE(problems[0].what.empty());
        EXPECT_FALSE(problems[0].remedy.empty());
        EXPECT_GE(tileset.tileWidth, 1);
    }
}

TEST(Tileset, randomMutationsNeverCrashAndReadFilesAreWrittenBackUnchanged) {
    Random random = Random::seeded(2);
    for (int i = 0; i < 3000; ++i) {
        const std::string text = test::withWrongBytes(std::string{kFull}, random);
        std::vector<Error> problems;
        const Result<Tileset> read = parseTileset(text, "x", problems);
        if (!read.ok()) continue;
        const std::string written = writeTileset(*read);
        const Result<Tileset> again = parseTileset(written, "x", problems);
        ASSERT_TRUE(again.ok()) << written;
        ASSERT_EQ(writeTileset(*again), written);
    }
}

}  // namespace
}  // namespace plumb
