#include "import/import_ldtk.hpp"

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "import/import_file.hpp"
#include "platform/image_file.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

constexpr const char* kDefinitions = R"("jsonVersion": "1.5.3", "bgColor": "#000000", "toc": [], "defs": {
 "layers": [
  {"uid": 1, "identifier": "Ground", "type": "IntGrid", "gridSize": 16, "parallaxFactorX": 0, "parallaxFactorY": 0,
   "parallaxScaling": true, "autoRuleGroups": [{}], "intGridValues": [
    {"value": 1, "identifier": "walls", "color": "#804020"}, {"value": 3, "identifier": "water", "color": "#2040FF"}]},
  {"uid": 2, "identifier": "Far", "type": "Tiles", "gridSize": 16, "parallaxFactorX": 0.5, "parallaxFactorY": 0,
   "parallaxScaling": false},
  {"uid": 3, "identifier": "Things", "type": "Entities", "gridSize": 16}],
 "tilesets": [
  {"uid": 10, "identifier": "Art", "relPath": "art.png", "pxWid": 64, "pxHei": 32, "tileGridSize": 16, "spacing": 0,
   "padding": 0, "customData": [{"tileId": 2, "data": "hot"}], "enumTags": [{"enumValueId": "Lava", "tileIds": [2]}]},
  {"uid": 11, "identifier": "Icons", "relPath": null, "embedAtlas": "LdtkIcons", "pxWid": 512, "pxHei": 1024,
   "tileGridSize": 16, "spacing": 0, "padding": 0}],
 "entities": [
  {"uid": 20, "identifier": "Chest", "renderMode": "Tile", "tileRenderMode": "FitInside", "tileOpacity": 1,
   "resizableX": false, "resizableY": false, "color": "#FF0000"},
  {"uid": 21, "identifier": "Zone", "renderMode": "Rectangle", "resizableX": true, "resizableY": true, "color": "#00FF00"}],
 "enums": [{"identifier": "Loot", "uid": 30, "values": [{"id": "Gold"}]}], "externalEnums": [], "levelFields": []})";

constexpr const char* kLevel =
    R"("fieldInstances": [{"__identifier": "music", "__type": "String", "__value": "cave"}],
 "layerInstances": [
  {"__identifier": "Things", "__type": "Entities", "__cWid": 4, "__cHei": 2, "__gridSize": 16, "__opacity": 1,
   "__pxTotalOffsetX": 0, "__pxTotalOffsetY": 0, "iid": "l3", "layerDefUid": 3, "visible": true, "entityInstances": [
    {"__identifier": "Chest", "iid": "e1", "defUid": 20, "px": [24, 32], "__pivot": [0.5, 1], "width": 32, "height": 32,
     "__smartColor": "#FF0000", "__tags": ["loot"], "__tile": {"tilesetUid": 11, "x": 16, "y": 0, "w": 16, "h": 16},
     "fieldInstances": [
      {"__identifier": "count", "__type": "Int", "__value": 3},
      {"__identifier": "loot", "__type": "Array<LocalEnum.Loot>", "__value": ["Gold"]},
      {"__identifier": "way", "__type": "Array<Point>", "__value": [{"cx": 1, "cy": 0}]},
      {"__identifier": "opens", "__type": "EntityRef", "__value": {"entityIid": "e2", "layerIid": "l3"}},
      {"__identifier": "note", "__type": "Multilines", "__value": null},
      {"__identifier": "look", "__type": "Tile", "__value": {"tilesetUid": 10, "x": 0, "y": 0, "w": 16, "h": 16}}]},
    {"__identifier": "Zone", "iid": "e2", "defUid": 21, "px": [0, 0], "__pivot": [0, 0], "width": 48, "height": 16,
     "__smartColor": "#00FF00", "__tags": [], "__tile": null, "fieldInstances": []}]},
  {"__identifier": "Ground", "__type": "IntGrid", "__cWid": 4, "__cHei": 2, "__gridSize": 16, "__opacity": 0.5,
   "__pxTotalOffsetX": 0, "__pxTotalOffsetY": 0, "__tilesetDefUid": 10, "iid": "l1", "layerDefUid": 1, "visible": true,
   "intGridCsv": [0, 0, 0, 0, 1, 1, 3, 1], "autoLayerTiles": [
    {"px": [0, 16], "src": [0, 0], "f": 0, "t": 0, "a": 1}, {"px": [0, 16], "src": [16, 0], "f": 1, "t": 1, "a": 1},
    {"px": [16, 16], "src": [0, 0], "f": 0, "t": 0, "a": 1}, {"px": [-8, 8], "src": [32, 0], "f": 3, "t": 2, "a": 1},
    {"px": [32, 16], "src": [0, 0], "f": 0, "t": 0, "a": 0.25}], "gridTiles": [], "entityInstances": []},
  {"__identifier": "Far", "__type": "Tiles", "__cWid": 4, "__cHei": 2, "__gridSize": 16, "__opacity": 1,
   "__pxTotalOffsetX": 0, "__pxTotalOffsetY": 4, "__tilesetDefUid": 10, "iid": "l2", "layerDefUid": 2, "visible": false,
   "autoLayerTiles": [], "gridTiles": [{"px": [48, 0], "src": [48, 16], "f": 2, "t": 7, "a": 1}], "entityInstances": []}])";

std::string levelText(const std::string& name, int x, int y, const char* content = kLevel) {
    return format(
        R"({"identifier": "{}", "iid": "i-{}", "worldX": {}, "worldY": {}, "worldDepth": 0, "pxWid": 64,
 "pxHei": 32, "__bgColor": "#112233", "bgRelPath": null, "externalRelPath": null, {}})",
        name, name, x, y, content);
}

/// An LDtk project in a temporary folder, and the scene imported from it.
class ImportLdtkTest : public testing::Test {
protected:
    void SetUp() override {
        const Image art{64, 32, std::vector<std::uint8_t>(64 * 32 * 4, 200)};
        put("art.png", *encodePng(art));
        ASSERT_TRUE(writeFile(project_ / "project.json", "{\"resolution\": [320, 180]}").ok());
    }
    void put(const std::string& name, const std::string& text) {
        ASSERT_TRUE(writeFile(folder_.path / "art" / name, text).ok());
    }
    void import(const std::string& text) {
        put("game.ldtk", text);
        const Result<ImportReport> imported = importFile(folder_.path / "art/game.ldtk", scene_, project_);
        ASSERT_TRUE(imported.ok()) << imported.error().text();
        report_ = *imported;
    }
    void importLevels(const std::string& layout, const std::vector<std::string>& levels) {
        std::string list;
        for (const std::string& level : levels) list += (list.empty() ? "" : ", ") + level;
        import(
            format(R"({{}, "worldLayout": "{}", "worlds": [], "levels": [{}]})", kDefinitions, layout, list));
    }
    Json read(const Path& file) const { return *parseJson(*readFile(file), "test"); }
    Json entity(const std::string& name) const {
        const Json scene = read(scene_);
        for (const Json& entity : scene["entities"]) {
            if (entity.value("name", "") == name) return entity;
        }
        ADD_FAILURE() << "there is no entity " << name << "\n" << report_.text();
        return Json::object();
    }
    [[nodiscard]] bool tells(std::string_view text) const {
        return report_.text().find(text) != std::string::npos;
    }

    test::TemporaryFolder folder_;
    Path project_ = folder_.path / "game";
    Path scene_ = project_ / "scenes/level.scene.json";
    ImportReport report_;
};

TEST_F(ImportLdtkTest, aLevelBecomesAnEntityWithLayersAndThingsBelowIt) {
    importLevels("Free", {levelText("Cave", 100, -50)});

    const Json cave = entity("Cave");
    EXPECT_EQ(cave["components"]["Transform"]["position"].dump(), "[100,-50]");
    EXPECT_EQ(cave["properties"]["music"], "cave");
    EXPECT_EQ(entity("Chest")["parent"], cave["id"]);
    EXPECT_EQ(read(scene_)["background"], "#112233");
    EXPECT_EQ(report_.levels, 1);
    EXPECT_EQ(report_.layers, 3);
    EXPECT_EQ(report_.objects, 2);
    EXPECT_EQ(report_.tiles, 4 + 6) << "4 IntGrid values and 6 tiles";
}

TEST_F(ImportLdtkTest, tilesThatLieOverEachOtherBecomeLayersAndThoseOffTheGridSprites) {
    importLevels("Free", {levelText("Cave", 0, 0)});

    EXPECT_EQ(entity("Ground")["components"]["TileLayer"]["cells"]["rows"].dump(),
              R"(["0 0 0 0","1 1 0 0"])");
    const Json above = entity("Ground 2")["components"]["TileLayer"];
    EXPECT_EQ(above["cells"]["rows"].dump(), R"(["0 0 0 0","2x 0 0 0"])");
    EXPECT_GT(above["layer"], entity("Ground")["components"]["TileLayer"]["layer"]);
    const Json loose = entity("tile 2")["components"];
    EXPECT_EQ(loose["Transform"]["position"].dump(), "[-8,8]");
    EXPECT_TRUE(loose["Sprite"]["flipX"] == true && loose["Sprite"]["flipY"] == true);
    EXPECT_GT(loose["Sprite"]["layer"], above["layer"]) << "drawn above the tiles of the grid";
    EXPECT_EQ(entity("tile 0")["components"]["Sprite"]["tint"], "#ffffff20") << "0.25 of the layer's 0.5";
}

TEST_F(ImportLdtkTest, valuesOfAnIntGridAreTilesThatAreSolidByTheirName) {
    importLevels("Free", {levelText("Cave", 0, 0)});

    const Json values = entity("Ground values")["components"];
    EXPECT_EQ(values["TileLayer"]["cells"]["rows"].dump(), R"(["0 0 0 0","1 1 2 1"])");
    EXPECT_TRUE(values.contains("Hidden")) << "tiles placed by rules replace the values";
    EXPECT_TRUE(values.contains("TileCollider"));
    const Json tileset = read(project_ / values["TileLayer"]["tileset"].get<std::string>());
    EXPECT_EQ(tileset["tiles"][0]["collision"], "full");
    EXPECT_FALSE(tileset["tiles"][1].contains("collision"));
    EXPECT_EQ(tileset["tiles"][1]["properties"]["value"], 3);
    EXPECT_TRUE(tells("\"walls\" were made solid"));
}

/// LDtk shows the values of an IntGrid only if no auto-layer rules draw them.
TEST_F(ImportLdtkTest, valuesThatRulesDrawAreHiddenAlsoWhereTheyDrewNothing) {
    constexpr const char* kValues = R"("fieldInstances": [], "layerInstances": [
  {"__identifier": "Ground", "__type": "IntGrid", "__cWid": 4, "__cHei": 1, "__gridSize": 16, "__opacity": 1,
   "__pxTotalOffsetX": 0, "__pxTotalOffsetY": 0, "__tilesetDefUid": {}, "iid": "l1", "layerDefUid": 1, "visible": true,
   "intGridCsv": [1, 1, 3, 1], "autoLayerTiles": [], "gridTiles": [], "entityInstances": []}])";
    const auto isHidden = [&](const char* tileset, const char* source) {
        std::string text = format(R"({{}, "worldLayout": "Free", "worlds": [], "levels": [{}]})",
                                  kDefinitions, levelText("Cave", 0, 0, format(kValues, tileset).c_str()));
        const std::string_view far = R"({"uid": 2, "identifier": "Far",)";
        text.replace(text.find(far), far.size(), std::string{far} + source);
        import(text);
        return entity("Ground values")["components"].contains("Hidden");
    };
    EXPECT_FALSE(isHidden("null", ""));
    EXPECT_TRUE(isHidden("10", ""));
    EXPECT_TRUE(isHidden("null", R"("autoSourceLayerDefUid": 1,)"));
}

TEST_F(ImportLdtkTest, fieldsOfAllTypesBecomePropertiesAndReferencesFindTheirEntity) {
    importLevels("Free", {levelText("Cave", 0, 0)});

    const Json chest = entity("Chest");
    EXPECT_EQ(chest["components"]["Transform"]["position"].dump(), "[24,32]");
    EXPECT_EQ(chest["components"]["Sprite"]["pivot"].dump(), "[0.5,1]");
    EXPECT_EQ(chest["properties"]["count"], 3);
    EXPECT_EQ(chest["properties"]["loot"].dump(), R"(["Gold"])");
    EXPECT_EQ(chest["properties"]["way"][0]["position"].dump(), "[24,8]");
    EXPECT_EQ(chest["properties"]["opens"]["entity"], entity("Zone")["id"]);
    EXPECT_EQ(chest["properties"]["look"]["tileset"], "Art");
    EXPECT_TRUE(chest["properties"].contains("note"));
    EXPECT_EQ(chest["ldtk"]["tags"].dump(), R"(["loot"])");
    EXPECT_EQ(chest["ldtk"]["tile"]["tileset"], "Icons");
    EXPECT_TRUE(tells("Icons")) << "LDtk's built-in icons are not in a file, which must be reported";
    const Json zone = entity("Zone")["components"];
    EXPECT_EQ(zone["BoxCollider"]["isTrigger"], true);
    EXPECT_EQ(zone["BoxCollider"]["width"], 48);
}

TEST_F(ImportLdtkTest, parallaxCountsTheOtherWayAndHiddenLayersStayHidden) {
    importLevels("Free", {levelText("Cave", 0, 0)});

    const Json far = entity("Far")["components"];
    EXPECT_EQ(far["ParallaxLayer"]["factor"].dump(), "[0.5,1]");
    EXPECT_EQ(far["Transform"]["position"].dump(), "[0,4]");
    EXPECT_TRUE(far.contains("Hidden"));
    EXPECT_EQ(far["TileLayer"]["cells"]["rows"].dump(), R"(["0 0 0 8y","0 0 0 0"])");
    EXPECT_FALSE(entity("Ground")["components"].contains("ParallaxLayer"));
    const Json tileset = read(project_ / far["TileLayer"]["tileset"].get<std::string>());
    EXPECT_EQ(tileset["tiles"][0]["properties"].dump(), R"({"data":"hot","tags":["Lava"]})");
}

TEST_F(ImportLdtkTest, everyLayoutPutsItsLevelsBesideEachOther) {
    const auto placeOf = [&](const char* name) {
        return entity(name)["components"]["Transform"].value("position", Json::array({0, 0})).dump();
    };
    for (const char* layout : {"Free", "GridVania"}) {
        SCOPED_TRACE(layout);
        importLevels(layout, {levelText("A", 0, 0), levelText("B", 256, 128)});
        EXPECT_EQ(placeOf("A"), "[0,0]");
        EXPECT_EQ(placeOf("B"), "[256,128]");
    }
    importLevels("LinearHorizontal", {levelText("A", -1, -1), levelText("B", -1, -1)});
    EXPECT_EQ(placeOf("B"), "[96,0]");
    importLevels("LinearVertical", {levelText("A", -1, -1), levelText("B", -1, -1)});
    EXPECT_EQ(placeOf("B"), "[0,64]");
    EXPECT_EQ(entity("camera")["components"]["Camera"]["limits"].dump(), "[0,0,64,96]");
}

TEST_F(ImportLdtkTest, worldsBecomeScenesAndLevelsInFilesOfTheirOwnAreRead) {
    put("game/Deep.ldtkl", levelText("Deep", 0, 0));
    const std::string named =
        levelText("Deep", 0, 0, R"("externalRelPath": "game/Deep.ldtkl", "layerInstances": null)");
    import(format(R"({{}, "levels": [], "worlds": [
        {"iid": "w1", "identifier": "Over", "worldLayout": "Free", "levels": [{}]},
        {"iid": "w2", "identifier": "Under", "worldLayout": "Free", "levels": [{}]}]})",
                  kDefinitions, levelText("High", 0, 0), named));

    EXPECT_EQ(report_.levels, 2);
    EXPECT_EQ(entity("High")["components"].size(), 1u);
    scene_ = project_ / "scenes/level-Under.scene.json";
    EXPECT_EQ(entity("Chest")["parent"], entity("Deep")["id"]);
    EXPECT_TRUE(tells("scenes/level-Under.scene.json"));
}

TEST_F(ImportLdtkTest, importingAgainChangesNoByte) {
    importLevels("Free", {levelText("A", 0, 0), levelText("B", 256, 128)});
    const std::string first = *readFile(scene_);
    importLevels("Free", {levelText("A", 0, 0), levelText("B", 256, 128)});
    EXPECT_EQ(*readFile(scene_), first);
}

TEST_F(ImportLdtkTest, unknownKeysAreReportedAndWhatOnlyTheEditorNeedsIsNamed) {
    import(
        format(R"({{}, "worldLayout": "Free", "worlds": [], "nextUid": 4, "portals": [1], "levels": [{}]})",
               kDefinitions, levelText("A", 0, 0)));
    EXPECT_TRUE(tells("the key \"portals\" is unknown"));
    EXPECT_EQ(report_.editorKeys.count("nextUid"), 1u);
    EXPECT_TRUE(tells("1 key that only LDtk needs was left out: nextUid")) << report_.text();
}

TEST_F(ImportLdtkTest, aDrawingOfAsepriteIsNamedWithItsRemedyAndItsPngTaken) {
    std::string text = format(R"({{}, "worldLayout": "Free", "worlds": [], "levels": [{}]})", kDefinitions,
                              levelText("A", 0, 0));
    text.replace(text.find("art.png"), 7, "art.aseprite");
    import(text);
    EXPECT_FALSE(tells("art.aseprite is an Aseprite file")) << "art.png is in the same folder";
    std::filesystem::remove(folder_.path / "art/art.png");
    import(text);
    EXPECT_TRUE(tells("art.aseprite is an Aseprite file"));
}

/// LDtk counts tiles that the image's edge cuts off. A tile's position in the image has priority over its id.
TEST_F(ImportLdtkTest, tilesOfAPictureThatIsNoMultipleOfTheGridLookAsInLdtk) {
    constexpr const char* kTiles = R"("fieldInstances": [], "layerInstances": [
  {"__identifier": "Far", "__type": "Tiles", "__cWid": 4, "__cHei": 2, "__gridSize": 16, "__opacity": 1,
   "__pxTotalOffsetX": 0, "__pxTotalOffsetY": 0, "__tilesetDefUid": 10, "iid": "l2", "layerDefUid": 1, "visible": true,
   "autoLayerTiles": [], "gridTiles": [{"px": [0, 0], "src": [0, 16], "f": 0, "t": 5, "a": 1},
    {"px": [16, 0], "src": [64, 0], "f": 0, "t": 4, "a": 1}, {"px": [32, 0], "src": [16, 16], "f": 0, "t": 99, "a": 1},
    {"px": [48, 0], "src": [7, 7], "f": 0, "t": 99, "a": 1}], "entityInstances": []}])";
    std::string text = format(R"({{}, "worldLayout": "Free", "worlds": [], "levels": [{}]})", kDefinitions,
                              levelText("Cave", 0, 0, kTiles));
    text.replace(text.find("\"pxWid\": 64"), 11, "\"pxWid\": 70");
    import(text);
    const Json far = entity("Far")["components"]["TileLayer"];
    EXPECT_EQ(far["cells"]["rows"].dump(), R"(["6 5 7 0","0 0 0 0"])");
    const Json tileset = read(project_ / far["tileset"].get<std::string>());
    EXPECT_EQ(tileset["columns"], 5);
    EXPECT_TRUE(tells("1 tiles were left out, because tileset Art has no tiles of these ids"))
        << report_.text();
}

TEST_F(ImportLdtkTest, pivotsAndTheParallaxOfEntitiesComeAlong) {
    std::string text = format(R"({{}, "worldLayout": "Free", "worlds": [], "levels": [{}]})", kDefinitions,
                              levelText("Cave", 0, 0));
    const std::string_view layer =
        R"({"uid": 3, "identifier": "Things", "type": "Entities", "gridSize": 16})";
    text.replace(
        text.find(layer), layer.size(),
        R"({"uid": 3, "identifier": "Things", "type": "Entities", "gridSize": 16, "parallaxFactorX": 0.25,
                     "parallaxFactorY": 0, "parallaxScaling": false})");
    const std::string_view zone = R"("px": [0, 0], "__pivot": [0, 0])";
    text.replace(text.find(zone), zone.size(), R"("px": [0, 0], "__pivot": [0.5, 1])");
    import(text);
    EXPECT_EQ(entity("Chest")["components"]["ParallaxLayer"]["factor"].dump(), "[0.75,1]");
    EXPECT_EQ(entity("Zone")["ldtk"]["pivot"].dump(), "[0.5,1]");
    EXPECT_TRUE(tells("its entities without an image do not move with it"));
}

TEST_F(ImportLdtkTest, areasOutsideAnImageAreReported) {
    std::string text = format(R"({{}, "worldLayout": "Free", "worlds": [], "levels": [{}]})", kDefinitions,
                              levelText("Cave", 0, 0));
    const std::string_view tile = R"("x": 16, "y": 0, "w": 16, "h": 16})";
    text.replace(text.find(tile), tile.size(), R"("x": 16, "y": 0, "w": 1e30, "h": 16})");
    import(text);
    EXPECT_FALSE(entity("Chest")["components"].contains("Sprite"));
    EXPECT_TRUE(tells("the tile's rectangle is negative or too large")) << report_.text();
}

TEST_F(ImportLdtkTest, aWorldThatFailsLeavesNoFileOfTheOthers) {
    const std::string worlds = format(R"({{}, "levels": [], "worlds": [
        {"iid": "w1", "identifier": "Over", "worldLayout": "Free", "levels": [{}]},
        {"iid": "w2", "identifier": "Un/der", "worldLayout": "Free", "levels": [{}]}]})",
                                      kDefinitions, levelText("High", 0, 0), levelText("Low", 0, 0));
    std::filesystem::create_directories(project_ / "scenes/level-Un_der.scene.json");
    put("game.ldtk", worlds);
    const Result<ImportReport> failed = importFile(folder_.path / "art/game.ldtk", scene_, project_);
    ASSERT_FALSE(failed.ok());
    EXPECT_NE(failed.error().text().find("level-Un_der"), std::string::npos) << failed.error().text();
    EXPECT_EQ(filesBelow(project_, "").size(), 1u) << "only project.json must exist";
    std::filesystem::remove(project_ / "scenes/level-Un_der.scene.json");
    import(worlds);
    EXPECT_TRUE(readFile(project_ / "scenes/level-Un_der.scene.json").ok());
}

TEST_F(ImportLdtkTest, filesThatAreNotLdtkProjectsAreRejected) {
    put("bad.ldtk", "{\"levels\": []}");
    EXPECT_FALSE(importLdtk(folder_.path / "art/bad.ldtk", scene_).ok());
    put("bad.ldtk", "[1, 2");
    EXPECT_FALSE(importLdtk(folder_.path / "art/bad.ldtk", scene_).ok());
}

}  // namespace
}  // namespace plumb
