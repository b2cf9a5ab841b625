// Small files that declare huge content are rejected, or read in little time and memory.

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "import/import_file.hpp"
#include "platform/image_file.hpp"
#include "reflect/json.hpp"
#include "tests/support/reader_cost.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

class ImportLimits : public testing::Test {
protected:
    ImportLimits() {
        const Image art{64, 32, std::vector<std::uint8_t>(64 * 32 * 4, 200)};
        put("art.png", *encodePng(art));
        put("game/project.json", "{}");
    }
    void put(const std::string& name, const std::string& text) const {
        EXPECT_TRUE(writeFile(folder.path / name, text).ok());
    }
    /// Imports a file. @return the text of the report or of the error
    [[nodiscard]] std::string import(const std::string& name, const std::string& text) const {
        put(name, text);
        std::string said;
        const test::ReaderCost cost;
        cost.expectSmall([&] {
            const Result<ImportReport> report = importFile(folder.path / name, {}, folder.path / "game");
            said = report ? report->text() : report.error().text();
        });
        return said;
    }

    test::TemporaryFolder folder{test::memoryFolder()};
};

/// Returns an LDtk project with one level of one layer. @param grid  cell size, px @param tiles  tiles, JSON
std::string ldtkText(int cells, int grid, int tileGrid, const std::string& tiles,
                     const std::string& more = "") {
    return format(
        R"({"jsonVersion": "1.5.3", "worlds": [], "defs": {"layers": [], "entities": [], "tilesets": [
  {"uid": 10, "identifier": "Art", "relPath": "art.png", "pxWid": 64, "pxHei": 32, "tileGridSize": {}}]},
 "levels": [{"identifier": "A", "iid": "a", "pxWid": 64, "pxHei": 32, "fieldInstances": [], "layerInstances": [
  {"__identifier": "L", "__type": "IntGrid", "__cWid": {}, "__cHei": {}, "__gridSize": {}, "__tilesetDefUid": 10,
   "iid": "l", "layerDefUid": 1, "intGridCsv": [1, 2], "gridTiles": [{}]}{}]}]})",
        tileGrid, cells, cells, grid, tiles, more);
}

std::string manyTiles(int count, int step) {
    std::string tiles;
    for (int i = 0; i < count; ++i) {
        tiles += format("{}{\"px\": [{}, {}], \"src\": [0, 0], \"f\": 0, \"t\": 0, \"a\": 1}",
                        i == 0 ? "" : ", ", i % 64 * step, i / 64 * step);
    }
    return tiles;
}

TEST_F(ImportLimits, anLdtkLayerThatExceedsTheCellLimitIsIgnored) {
    const std::string said = import("game.ldtk", ldtkText(16384, 16, 16, manyTiles(4, 16)));
    EXPECT_NE(said.find("16384 x 16384 cells"), std::string::npos) << said;
}

TEST_F(ImportLimits, aLargeEmptyLdtkLayerAllocatesNoCells) {
    const std::string said = import("game.ldtk", ldtkText(8192, 16, 16, manyTiles(4, 16)));
    EXPECT_NE(said.find("found 2 cells, expected 67108864"), std::string::npos) << said;
}

TEST_F(ImportLimits, tilesMuchLargerThanTheirCellsAreStackedFast) {
    for (const int tileGrid : {32, 4096, 16384})
        EXPECT_FALSE(import("game.ldtk", ldtkText(64, 8, tileGrid, manyTiles(4000, 8))).empty());
}

TEST_F(ImportLimits, manyTilesOverOneCellAreStackedFastAndWithLittleMemory) {
    const std::string said = import("game.ldtk", ldtkText(64, 16, 16, manyTiles(6000, 0)));
    EXPECT_NE(said.find("drawing orders"), std::string::npos) << said;
}

TEST_F(ImportLimits, asepriteFramesThatDeclareAHugeSizeAreClippedToTheirCells) {
    std::string frames;
    for (int i = 0; i < 300; ++i) {
        frames += format(
            R"({}{"filename": "{}", "frame": {"x": 0, "y": 0, "w": 16384, "h": 16384}, "rotated": true,
            "spriteSourceSize": {"x": 0, "y": 0, "w": 8, "h": 8}, "sourceSize": {"w": {}, "h": 8}, "duration": 100})",
            i == 0 ? "" : ", ", i, 8 + i % 2);
    }
    std::string text = "{\"frames\": [" + frames + R"(], "meta": {"image": "art.png"}})";
    EXPECT_NE(import("art.json", text).find("300 frames reach beyond"), std::string::npos);
    for (std::size_t at = text.find("\"h\": 8}, \"duration\""); at != std::string::npos;
         at = text.find("\"h\": 8}, \"duration\"", at))
        text.replace(at, 6, "\"h\": 9999");
    EXPECT_NE(import("art.json", text).find("do not fit into one image"), std::string::npos);
}

TEST_F(ImportLimits, aTilesetThatDeclaresAMillionTilesOfAnotherSizeBecomesASmallFile) {
    const std::string said = import(
        "map.tmx", R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="far" tilewidth="1" tileheight="1" columns="16384" tilecount="1000000">
  <image source="none.png" width="16384" height="16384"/></tileset>
 <layer name="a" width="1" height="1"><data encoding="csv">5</data></layer></map>)");
    EXPECT_NE(said.find("differ in size from the map's cells"), std::string::npos) << said;
}

TEST_F(ImportLimits, aVeryLongIsometricLayerIsIgnored) {
    std::string row = "1";
    for (int i = 1; i < 16000; ++i) row += ",0";
    const std::string said = import(
        "map.tmx", R"(<map orientation="isometric" width="16000" height="1" tilewidth="16" tileheight="8">
 <tileset firstgid="1" name="a" tilewidth="16" tileheight="8"><image source="art.png"/></tileset>
 <layer name="row" width="16000" height="1"><data encoding="csv">)" +
                       row + "</data></layer></map>");
    EXPECT_NE(said.find("half cells"), std::string::npos) << said;
}

TEST_F(ImportLimits, tilesOfALargeMapMakeALimitedNumberOfColliders) {
    std::string cells = "1";
    for (int i = 1; i < 200 * 200; ++i) cells += ",1";
    const std::string said = import(
        "map.tmx", R"(<map orientation="staggered" width="200" height="200" tilewidth="16" tileheight="8">
 <tileset firstgid="1" name="a" tilewidth="16" tileheight="8"><image source="art.png"/><tile id="0"><objectgroup>
  <object id="1" x="0" y="0" width="16" height="8"><ellipse/></object></objectgroup></tile></tileset>
 <layer name="all" width="200" height="200"><data encoding="csv">)" +
                       cells + "</data></layer></map>");
    EXPECT_NE(said.find("34539 colliders of its tiles were left out"), std::string::npos) << said;
}

TEST_F(ImportLimits, turnedTilesOfHugeSizeMakeNoHugeImage) {
    const std::string said =
        import("map.tmx", R"(<map orientation="hexagonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="a" tilewidth="16384" tileheight="16384" columns="1" tilecount="1">
  <image source="art.png" width="16384" height="16384"/></tileset>
 <layer name="one" width="1" height="1"><data encoding="csv">268435457</data></layer></map>)");
    EXPECT_FALSE(said.empty());
}

TEST_F(ImportLimits, animatedTilesOfHugeCellsMakeNoHugeImage) {
    const std::string said = import(
        "map.tmx", R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16384" tileheight="16384">
 <tileset firstgid="1" name="a" tilewidth="16384" tileheight="16384" columns="1" tilecount="2">
  <image source="art.png"/><tile id="0"><animation><frame tileid="0" duration="9"/></animation></tile></tileset>
 <objectgroup name="o"><object id="1" gid="1" x="0" y="0"/></objectgroup></map>)");
    EXPECT_FALSE(said.empty());
}

}  // namespace
}  // namespace plumb
