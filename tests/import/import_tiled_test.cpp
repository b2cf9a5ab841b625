#include "import/import_tiled.hpp"

#include <map>

#include <gtest/gtest.h>

#include "assets/autotile.hpp"
#include "core/text.hpp"
#include "platform/image_file.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/tiles_json.hpp"
#include "tests/support/foreign_maps.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

constexpr const char* kMap =
    R"(<map orientation="orthogonal" width="2" height="1" tilewidth="16" tileheight="16"
 backgroundcolor="#102030" parallaxoriginx="100" parallaxoriginy="50">
 <tileset firstgid="1" name="same" tilewidth="16" tileheight="16"><image source="sheet.png" trans="ff00ff"/>
  <tile id="1"><animation><frame tileid="0" duration="100"/><frame tileid="1" duration="50"/></animation>
   <objectgroup><object id="1" x="0" y="0" width="16" height="16"/></objectgroup></tile></tileset>
 <tileset firstgid="10" name="big" tilewidth="32" tileheight="32"><tileoffset x="-8" y="0"/><image source="sheet.png"/></tileset>
 <layer name="ground" width="2" height="1"><data encoding="csv">2147483649,10</data></layer>
 <objectgroup name="things" parallaxx="0.5">
  <object id="1" name="crate" gid="1" x="10" y="20" width="32" height="8" rotation="90"><properties>
   <property name="loot" value="coin"/></properties></object>
  <object id="2" gid="2" x="0" y="0" width="16" height="16"/>
  <object id="3" name="door" x="5" y="6" width="7" height="8"/>
  <object id="4" name="path" x="5" y="6"><polyline points="0,0 9,9"/></object>
  <object id="5" name="sign" x="5" y="6" width="90" height="20"><text pixelsize="10" color="#80ff0000">Hi</text></object>
 </objectgroup></map>)";

/// A project, a map in a folder next to it, and the scene imported from the map.
class ImportTiledTest : public ::testing::Test {
protected:
    void SetUp() override {
        Image sheet{32, 32, std::vector<std::uint8_t>(32 * 32 * 4, 255)};
        sheet.rgba[1] = 0;  // the first pixel is magenta
        ASSERT_TRUE(writeFile(folder_.path / "art/sheet.png", *encodePng(sheet)).ok());
        ASSERT_TRUE(writeFile(folder_.path / "art/level.tmx", kMap).ok());
        ASSERT_TRUE(writeFile(project_ / "project.json", "{\"resolution\": [320, 180]}").ok());
    }
    Result<ImportReport> import() { return importTiled(folder_.path / "art/level.tmx", scene_); }
    Json read(const Path& file) { return *parseJson(*readFile(file), "test"); }
    Json entity(const std::string& name) {
        const Json scene = read(scene_);
        for (const Json& entity : scene["entities"]) {
            if (entity.value("name", "") == name) return entity;
        }
        ADD_FAILURE() << "there is no entity " << name;
        return Json::object();
    }

    test::TemporaryFolder folder_;
    Path project_ = folder_.path / "game";
    Path scene_ = project_ / "scenes/level.scene.json";
};

TEST_F(ImportTiledTest, theReportCountsImportedItems) {
    const Result<ImportReport> report = import();

    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_EQ(report->scene, "scenes/level.scene.json");
    EXPECT_EQ(report->layers, 2);
    EXPECT_EQ(report->tiles, 2);
    EXPECT_EQ(report->objects, 5);
    EXPECT_EQ(report->tilesets, 2);
    EXPECT_EQ(report->images, 2);  // one image with the color key and one without
    EXPECT_TRUE(report->problems.empty()) << report->text();
    for (const std::string& file : report->files) EXPECT_TRUE(readFile(project_ / file).ok()) << file;
}

TEST_F(ImportTiledTest, importingAgainChangesNoByte) {
    ASSERT_TRUE(import().ok());
    const std::string first = *readFile(scene_);
    ASSERT_TRUE(import().ok());

    EXPECT_EQ(*readFile(scene_), first);
}

TEST_F(ImportTiledTest, aLayerOfTwoTilesetsBecomesTwoLayersOfTiles) {
    ASSERT_TRUE(import().ok());

    const Json same = entity("ground (same)")["components"];
    EXPECT_EQ(same["TileLayer"]["cells"]["rows"].dump(), R"(["1x 0"])");
    EXPECT_TRUE(same.contains("TileCollider"));
    EXPECT_EQ(entity("ground (big)")["components"]["TileLayer"]["cells"]["rows"].dump(), R"(["0 1"])");
    EXPECT_EQ(read(project_ / "assets/level/same.tileset.json")["tiles"][0]["collision"], "full");
    const Json big = read(project_ / "assets/level/big.tileset.json");
    EXPECT_EQ(big["tileSize"].dump(), "[16,16]");
    EXPECT_EQ(big["images"][0]["source"].dump(), "[0,0,32,32]");
    EXPECT_EQ(big["offset"].dump(), "[-8,0]");
}

TEST_F(ImportTiledTest, tileObjectsStandOnTheirLowerLeftCornerAndKeepTheirProperties) {
    ASSERT_TRUE(import().ok());

    const Json crate = entity("crate");
    // x of Tiled's position (10, 20) + (center of the view - parallax origin) * (1 - parallax)
    EXPECT_EQ(crate["components"]["Transform"]["position"].dump(), "[40,20]");
    EXPECT_NEAR(crate["components"]["Transform"]["rotation"].get<double>(), 1.5707963, 1e-6);
    EXPECT_EQ(crate["components"]["Transform"]["scale"].dump(), "[2,0.5]");
    EXPECT_EQ(crate["components"]["Sprite"]["pivot"].dump(), "[0,1]");
    EXPECT_EQ(crate["components"]["ParallaxLayer"]["factor"].dump(), "[0.5,1]");
    EXPECT_EQ(crate["properties"]["loot"], "coin");
}

TEST_F(ImportTiledTest, animatedTilesAreasAndTextsBecomeComponentsAndTheRestStaysData) {
    ASSERT_TRUE(import().ok());

    EXPECT_EQ(entity("things 2")["components"]["Animator"]["animation"], "assets/level/same-1.anim.json");
    EXPECT_EQ(entity("door")["components"]["BoxCollider"]["isTrigger"], true);
    EXPECT_EQ(entity("path")["tiled"]["points"].size(), 2u);
    EXPECT_EQ(entity("sign")["components"]["Label"]["text"], "Hi");
    EXPECT_EQ(entity("sign")["components"]["Label"]["color"], "#ff000080");
    EXPECT_EQ(read(scene_)["background"], "#102030");
}

TEST_F(ImportTiledTest, theColorKeyBecomesTransparent) {
    ASSERT_TRUE(import().ok());

    const Json tileset = read(project_ / "assets/level/same.tileset.json");
    const Result<Image> image =
        decodeImage(*readFile(project_ / tileset["image"].get<std::string>()), "sheet");
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->rgba[3], 0);
    EXPECT_EQ(image->rgba[7], 255);
}

TEST_F(ImportTiledTest, wangSetsBecomeTerrainsOneForEachColor) {
    ASSERT_TRUE(
        writeFile(folder_.path / "art/level.tmx",
                  R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="land" tilewidth="16" tileheight="16"><image source="sheet.png"/>
  <tile id="1" probability="0.25"/>
  <wangsets><wangset name="shore" type="corner" tile="-1">
    <wangcolor name="grass" color="#80ff0000" tile="-1" probability="1"/>
    <wangcolor name="" color="#0000ff" tile="-1" probability="1"/>
    <wangtile tileid="0" wangid="0,1,0,1,0,1,0,1"/><wangtile tileid="1" wangid="0,1,0,2,0,2,0,1"/></wangset>
   <wangset name="fence" type="edge" tile="-1"><wangcolor name="" color="#00ff00" tile="-1" probability="1"/>
    <wangtile tileid="2" wangid="1,0,0,0,1,0,0,0"/></wangset>
   <wangset name="wall" type="mixed" tile="-1"><wangcolor name="brick" color="#00ff00" tile="-1" probability="1"/>
    <wangtile tileid="3" wangid="1,1,1,1,0,0,0,0"/></wangset></wangsets></tileset>
 <layer name="ground" width="1" height="1"><data encoding="csv">1</data></layer></map>)")
            .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();

    const Json tileset = read(project_ / "assets/level/land.tileset.json");
    using N = Neighbour;
    const auto tilesOf = [&](std::size_t terrain) {
        std::vector<std::pair<int, int>> tiles;
        for (const Json& tile : tileset["terrains"][terrain]["tiles"])
            tiles.emplace_back(tile["tile"], tile["mask"]);
        return tiles;
    };
    using Tiles = std::vector<std::pair<int, int>>;
    const Json& terrains = tileset["terrains"];
    ASSERT_EQ(terrains.size(), 4u);
    EXPECT_EQ(terrains[0]["name"], "grass");
    EXPECT_EQ(terrains[0]["color"], "#ff0000");
    EXPECT_EQ(terrains[0]["mode"], "corners");
    EXPECT_EQ(tilesOf(0), (Tiles{{0, N::kCorners}}));
    // A tile of both colors belongs to the later one, which has no name, so the set's name is used.
    EXPECT_EQ(terrains[1]["name"], "shore");
    EXPECT_EQ(tilesOf(1), (Tiles{{1, N::kDownRight | N::kDownLeft}}));
    EXPECT_EQ(terrains[2]["mode"], "edges");
    EXPECT_EQ(tilesOf(2), (Tiles{{2, N::kUp | N::kDown}}));
    // A corner counts only between two edges, so the one at the lower right is removed.
    EXPECT_EQ(terrains[3]["mode"], "blob");
    EXPECT_EQ(tilesOf(3), (Tiles{{3, N::kUp | N::kUpRight | N::kRight}}));
    EXPECT_EQ(tileset["tiles"][0]["probability"], 0.25f);
}

/// Painting a Tiled map again with its imported terrains selects tiles with the same masks as the original
/// tiles.
TEST_F(ImportTiledTest, aMapOfTiledIsPaintedAgainByItsTerrains) {
    const std::vector<Path> maps = test::foreignMaps({"desert.tmx"});
    if (maps.empty()) GTEST_SKIP() << "Tiled's example desert.tmx is not on this machine (Debian: tiled)";
    const Result<ImportReport> report = importTiled(maps.front(), scene_);
    ASSERT_TRUE(report.ok()) << report.error().text();
    const std::string file = "assets/level/Desert.tileset.json";
    std::vector<Error> problems;
    const Result<Tileset> tileset = parseTileset(*readFile(project_ / file), file, problems);
    ASSERT_TRUE(tileset.ok()) << tileset.error().text();
    EXPECT_TRUE(problems.empty());
    std::map<int, std::pair<int, int>> meaning;  // terrain and mask of each tile
    for (const Terrain& terrain : tileset->terrains) {
        for (const TerrainTile& tile : terrain.tiles) meaning[tile.tile] = {terrain.id, tile.mask};
    }
    const Json ground = entity("Ground");
    const Result<ReadTiles> read = tilesFromJson(ground["components"]["TileLayer"]["cells"]);
    ASSERT_TRUE(read.ok());
    const TileGrid& cells = read->grid;
    const TileGrid terrain = terrainFromTiles(cells, *tileset);
    const Autotile autotile{*tileset};
    int compared = 0;
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            const auto was = meaning.find(tileOf(cells.at(x, y)));
            if (was == meaning.end()) continue;
            const std::optional<TileCell> is = autotile.cellAt(terrain, x, y);
            ASSERT_TRUE(is.has_value());
            EXPECT_EQ(meaning[tileOf(*is)], was->second) << x << ", " << y;
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST_F(ImportTiledTest, aMissingImageIsReportedAndTheMapIsImported) {
    std::filesystem::remove(folder_.path / "art/sheet.png");

    const Result<ImportReport> report = import();

    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_FALSE(report->problems.empty());
    EXPECT_TRUE(readFile(scene_).ok());
}

TEST_F(ImportTiledTest, theMapsThatOthersMadeComeInWithoutLoss) {
    const Path maps = test::sourceFolder() / "../shared/data/maps/tiled";
    for (const std::string& file : filesBelow(maps, ".tmx")) {
        SCOPED_TRACE(file);
        const Result<ImportReport> report = importTiled(maps / file, scene_);
        ASSERT_TRUE(report.ok()) << report.error().text();
        EXPECT_TRUE(report->problems.empty()) << report->text();
    }
}

TEST_F(ImportTiledTest, anIsometricMapStandsInAGridOfHalfCells) {
    constexpr const char* kIsometric =
        R"(<map orientation="isometric" width="2" height="2" tilewidth="32" tileheight="16">
 <tileset firstgid="1" name="t" tilewidth="32" tileheight="24"><image source="sheet.png" width="32" height="24"/></tileset>
 <layer name="ground" width="2" height="2"><data encoding="csv">1,0,0,1</data></layer>
 <objectgroup name="things"><object id="1" name="area" x="16" y="0" width="16" height="16"/></objectgroup></map>)";
    ASSERT_TRUE(writeFile(folder_.path / "art/level.tmx", kIsometric).ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();

    const Json layer = entity("ground")["components"];
    EXPECT_EQ(layer["TileLayer"]["tileSize"].dump(), "[16,8]");
    EXPECT_EQ(layer["TileLayer"]["cells"]["rows"].dump(), R"(["0 1 0","0 0 0","0 1 0"])")
        << "the cell farther back is in the upper row";
    EXPECT_EQ(layer["Transform"]["position"].dump(), "[0,8]");
    const Json area = entity("area");
    EXPECT_EQ(area["components"]["Transform"]["position"].dump(), "[48,8]");
    EXPECT_EQ(area["tiled"]["points"].dump(), "[[0,0],[16,8],[0,16],[-16,8]]");
    EXPECT_NE(report->text().find("isometric"), std::string::npos);
}

TEST_F(ImportTiledTest, theMapsOfAWorldComeBelowEntitiesAndShareTheirTilesets) {
    constexpr const char* kSmall =
        R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16" backgroundcolor="#ff0000">
 <tileset firstgid="1" source="t.tsx"/><layer name="a" width="1" height="1"><data encoding="csv">1</data></layer></map>)";
    ASSERT_TRUE(
        writeFile(folder_.path / "art/t.tsx",
                  R"(<tileset name="t" tilewidth="16" tileheight="16"><image source="sheet.png"/></tileset>)")
            .ok());
    ASSERT_TRUE(writeFile(folder_.path / "art/left.tmx", kSmall).ok());
    ASSERT_TRUE(writeFile(folder_.path / "art/right.tmx", kSmall).ok());
    ASSERT_TRUE(writeFile(folder_.path / "art/all.world",
                          R"({"type": "world", "maps": [{"fileName": "left.tmx", "x": 0, "y": 0},
        {"fileName": "right.tmx", "x": 160, "y": -8, "height": 16, "width": 16}, {"fileName": "gone.tmx", "x": 0, "y": 0}]})")
                    .ok());

    const Result<ImportReport> report = importTiledWorld(folder_.path / "art/all.world", scene_);

    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_EQ(report->levels, 2);
    EXPECT_EQ(report->tilesets, 1);
    EXPECT_EQ(report->problems.size(), 1u) << "gone.tmx does not exist";
    const Json right = entity("right");
    EXPECT_EQ(right["components"]["Transform"]["position"].dump(), "[160,-8]");
    int below = 0;
    const Json scene = read(scene_);
    for (const Json& child : scene["entities"]) below += child.value("parent", "") == right["id"] ? 1 : 0;
    EXPECT_EQ(below, 2) << "the map's layer and background";
    EXPECT_EQ(entity("camera")["components"]["Camera"]["limits"].dump(), "[0,-8,176,24]");
}

TEST_F(ImportTiledTest, unknownNamesAreReportedOnceAndWhatOnlyTiledNeedsIsNamed) {
    ASSERT_TRUE(writeFile(folder_.path / "art/level.tmx",
                          R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16"
 nextlayerid="3" glow="1"><hologram/><hologram/>
 <layer name="a" width="1" height="1" mode="add"><data encoding="csv">0</data></layer></map>)")
                    .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok());
    const std::string text = report->text();
    EXPECT_EQ(report->problems.size(), 3u) << text;
    EXPECT_NE(text.find("<hologram> is unknown"), std::string::npos);
    EXPECT_NE(text.find("\"glow\" is unknown"), std::string::npos);
    EXPECT_NE(text.find("the blend mode \"add\""), std::string::npos);
    EXPECT_NE(text.find("1 key that only Tiled needs was left out: nextlayerid"), std::string::npos) << text;
}

TEST_F(ImportTiledTest, everyShapeOfAnObjectBecomesATrigger) {
    std::string row;
    for (int i = 0; i < 70; ++i) row += format("{},{} ", i, i % 2);
    ASSERT_TRUE(
        writeFile(folder_.path / "art/level.tmx",
                  R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <objectgroup name="things">
  <object id="1" name="box" x="8" y="8" width="10" height="4" rotation="90"/>
  <object id="2" name="oval" x="0" y="0" width="20" height="10"><ellipse/></object>
  <object id="3" name="pill" x="0" y="0" width="20" height="10"><capsule/></object>
  <object id="4" name="roof" x="5" y="6"><polygon points="0,0 9,0 9,9"/></object>
  <object id="5" name="way" x="5" y="6"><polyline points="0,0 9,9"/></object>
  <object id="6" name="long" x="5" y="6"><polyline points=")" +
                      row + R"("/></object>
  <object id="7" name="spot" x="5" y="6"><point/></object></objectgroup></map>)")
            .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();
    const auto part = [&](const char* name, const char* component) {
        const Json components = entity(name)["components"];
        EXPECT_TRUE(components.contains(component)) << name << " " << components.dump();
        return components.contains(component) ? components[component] : Json::object();
    };
    EXPECT_EQ(part("box", "BoxCollider")["width"], 10);
    EXPECT_NEAR(entity("box")["components"]["Transform"]["rotation"].get<double>(), 1.5707963, 1e-6);
    EXPECT_EQ(part("oval", "PolygonCollider")["points"].size(), 24u);
    EXPECT_EQ(part("pill", "CapsuleCollider")["width"], 20);
    EXPECT_EQ(part("roof", "PolygonCollider")["points"].dump(), "[[0,0],[9,0],[9,9]]");
    EXPECT_EQ(part("way", "ChainCollider")["isTrigger"], true);
    EXPECT_EQ(entity("long")["components"].size(), 1u);
    EXPECT_EQ(entity("long")["tiled"]["points"].size(), 70u);
    EXPECT_EQ(entity("spot")["components"].size(), 1u);
    EXPECT_NE(report->text().find("1 shapes have more than 64 corners"), std::string::npos) << report->text();
}

TEST_F(ImportTiledTest, defaultPropertiesOfClassesAreReadFromTheTiledProject) {
    ASSERT_TRUE(writeFile(folder_.path / "game.tiled-project", R"({"propertyTypes": [
        {"name": "Door", "type": "class", "useAs": ["object"], "members": [
         {"name": "locked", "type": "bool", "value": true}, {"name": "key", "type": "string", "value": "gold"},
         {"name": "light", "type": "class", "propertyType": "Light", "value": {"far": 9}}]},
        {"name": "Light", "type": "class", "members": [{"name": "far", "type": "int", "value": 3},
         {"name": "color", "type": "color", "value": "#ff102030"}]},
        {"name": "Loop", "type": "class", "members": [
         {"name": "loop", "type": "class", "propertyType": "Loop", "value": {}}]},
        {"name": "Way", "type": "enum", "values": ["up", "down"]}, 7]})")
                    .ok());
    ASSERT_TRUE(
        writeFile(
            folder_.path / "art/level.tmx",
            R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16" class="Loop">
 <objectgroup name="things"><object id="1" name="gate" class="Door" x="5" y="6"><properties>
  <property name="key" value="iron"/></properties></object></objectgroup></map>)")
            .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();
    const Json properties = entity("gate")["properties"];
    EXPECT_EQ(properties["locked"], true);
    EXPECT_EQ(properties["key"], "iron");
    EXPECT_EQ(properties["light"]["value"]["far"], 9);
    EXPECT_EQ(properties["light"]["value"]["color"]["value"], "#ff102030");
    EXPECT_TRUE(read(scene_)["properties"].contains("loop"));
    EXPECT_EQ(report->problems.size(), 1u) << report->text();
}

TEST_F(ImportTiledTest, whatIsSaidOfManyPlacesIsOneLine) {
    ImportReport report;
    for (int i = 0; i < 9; ++i) report.problems.push_back({format("tile {}", i), "it is odd", "mend it"});
    report.problems.push_back({"map", "it is flat", "mend it"});
    const std::vector<Error> folded = report.foldedProblems();
    ASSERT_EQ(folded.size(), 2u);
    EXPECT_EQ(folded[0].where, "tile 0 and 8 more places");
    EXPECT_EQ(folded[1].where, "map");
}

TEST_F(ImportTiledTest, whatIsWrongWithTilesAndPropertiesIsReported) {
    ASSERT_TRUE(
        writeFile(folder_.path / "art/level.tmx",
                  R"(<map orientation="orthogonal" width="2" height="1" tilewidth="16" tileheight="16">
 <properties><property name="wet" type="bool" value="maybe"/><property name="depth" type="int" value="deep"/>
  <property name="twice" value="a"/><property name="twice" value="b"/></properties>
 <tileset firstgid="1" name="land" tilewidth="16" tileheight="16"><image source="sheet.png"/>
  <tile id="1"><animation><frame tileid="0" duration="9"/><frame tileid="7" duration="9"/></animation></tile>
  <tile id="9" type="far"/></tileset>
 <tileset firstgid="50" name="nothing" tilewidth="16" tileheight="16"><image source=""/></tileset>
 <layer name="ground" width="2" height="1" visible="perhaps"><data encoding="csv">1,6</data></layer>
 <objectgroup name="things"><object id="3" gid="12" x="0" y="16" width="16" height="16"/></objectgroup></map>)")
            .ok());
    const Result<ImportReport> report = import();
    ASSERT_TRUE(report.ok()) << report.error().text();
    const std::string text = report->text();
    for (const char* line :
         {"the property wet has the type bool and the value \"maybe\"",
          "the property depth has the type int and the value \"deep\"",
          "there are two properties named twice", "1 frames of the animation are beyond the 4 tiles",
          "tile 9: the tile id is beyond the 4 tiles", "the image has no file", "visible is \"perhaps\"",
          "1 cells contain tile ids beyond the 4 tiles of tileset land",
          "object 3: the object's tile 11 is past the 4 tiles"})
        EXPECT_NE(text.find(line), std::string::npos) << line << " in\n" << text;
    EXPECT_EQ(read(scene_)["properties"]["wet"], "maybe");
    EXPECT_EQ(read(scene_)["properties"]["twice"], "b");
}

TEST_F(ImportTiledTest, aTargetThatIsNotASceneFileIsRejected) {
    EXPECT_FALSE(importTiled(folder_.path / "art/level.tmx", project_ / "level.json").ok());
    EXPECT_FALSE(importTiled(folder_.path / "art/none.tmx", scene_).ok());
}

}  // namespace
}  // namespace plumb
