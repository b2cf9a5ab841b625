// Reads files in which one value was replaced by a value of another type, with every reader: each file must
// be read in part or rejected with a reason. PLUMB_TYPE_SWAPS is the number of files read of each kind, 0 for
// all.

#include <deque>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/game.hpp"
#include "app/game_content.hpp"
#include "app/project.hpp"
#include "assets/animation.hpp"
#include "assets/tileset.hpp"
#include "core/file.hpp"
#include "import/import_file.hpp"
#include "input/recorder.hpp"
#include "platform/image_file.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_file.hpp"
#include "tests/support/attribute_swaps.hpp"
#include "tests/support/foreign_maps.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_world.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/type_swaps.hpp"
#include "tests/support/word_swaps.hpp"

namespace plumb {
namespace {

using test::AttributeSwaps;
using test::eachTypeSwap;
using test::expectReportedWell;

constexpr const char* kPath = "scenes/swapped.scene.json";
constexpr const char* kPostPath = "prefabs/post.prefab.json";
constexpr const char* kLamp = R"({"format": 1, "entities": [
    {"id": "10", "name": "lamp", "components": {"Transform": {"position": [0, 4]}, "Sprite": {"width": 8, "height": 24}}},
    {"id": "11", "name": "bulb", "parent": "10", "components": {"Transform": {}, "Camera": {"follow": "10"}}}]})";
constexpr const char* kPost = R"({"format": 1, "entities": [
    {"id": "20", "name": "post", "components": {"Transform": {}}},
    {"id": "21", "parent": "20", "prefab": "prefabs/lamp.prefab.json",
     "children": {"0000000000000011": {"removed": true}}},
    {"id": "22", "parent": "20", "prefab": "prefabs/lamp.prefab.json", "without": ["Sprite"],
     "components": {"Transform": {"position": [7, 0]}},
     "children": {"0000000000000011": {"name": "small", "without": ["Camera"], "removed": false,
                                       "components": {"Transform": {"scale": [0.5, 0.5]}}}}}]})";
constexpr const char* kInstances =
    R"({"format": 1, "effects": {"gravity fields": "off"}, "background": "#102030",
    "layers": [{"name": "back", "order": -1}], "properties": {"x": 1}, "entities": [
    {"id": "a1", "name": "one", "prefab": "prefabs/lamp.prefab.json", "without": ["Sprite"], "components": {"Transform": {}},
     "children": {"0000000000000011": {"removed": true}}},
    {"id": "a2", "parent": "a1", "prefab": "prefabs/lamp.prefab.json", "children": {"0000000000000011":
     {"name": "small", "without": ["Camera"], "removed": false, "components": {"Transform": {"scale": [0.5, 0.5]}}}}}]})";
constexpr const char* kOldScene = R"({"format": 0, "effects": {}, "layers": [], "entities": [
    {"id": "a1", "position": [1, 2], "components": {"Transform": {"scale": [2, 2]}}}]})";

std::vector<std::string> textsOf(std::string_view ending) {
    std::vector<std::string> texts;
    const Path projects = test::sourceFolder() / "projects";
    for (const std::string& name : filesBelow(projects, ending)) texts.push_back(*readFile(projects / name));
    EXPECT_FALSE(texts.empty()) << ending;
    return texts;
}

struct TypeSwap : testing::Test {
    Game game;
    std::deque<PrefabLibrary> libraries;

    TypeSwap() { game.content.addSystems(game.world); }

    PrefabLibrary& lamps() {
        PrefabLibrary& library = libraries.emplace_back(game.types);
        library.add("prefabs/lamp.prefab.json", kLamp);
        library.add(kPostPath, kPost);
        return library;
    }

    /// Reads a scene; if it loads, it can be written as valid JSON.
    void read(const SceneContext& context, const std::string& text) {
        const Result<LoadReport> report = loadScene(game.world, context, kPath, text);
        if (report) {
            expectReportedWell(report->problems);
            const Result<Json> saved = parseJson(sceneToJson(game.world, context, sceneId(kPath)), kPath);
            EXPECT_TRUE(saved.ok()) << saved.error().text();
        } else {
            expectReportedWell(report.error());
        }
        unloadScene(game.world, sceneId(kPath));
        game.world.clear();
    }
};

TEST_F(TypeSwap, propertyScenes) {
    std::vector<std::string> samples{kInstances, kOldScene};
    std::vector<PrefabLibrary*> prefabs{&lamps(), &lamps()};
    const Path projects = test::sourceFolder() / "projects";
    for (const std::string& name : filesBelow(projects, ".scene.json")) {
        samples.push_back(*readFile(projects / name));
        prefabs.push_back(&libraries.emplace_back(game.types, projects / name.substr(0, name.find('/'))));
    }
    World made{game.types};
    const SceneContext context{game.types, prefabs.front()};
    samples.push_back(sceneToJson(made, context, addRandomScene(made, game.types, 77, 6, true)));
    prefabs.push_back(prefabs.front());
    eachTypeSwap(samples, 600, [&](std::size_t i, const std::string& text) {
        read({game.types, prefabs[i]}, text);
    });
}

/// Tests every value of the scenes with rarely used features.
TEST_F(TypeSwap, propertyEveryValueOfInstances) {
    PrefabLibrary& library = lamps();
    eachTypeSwap({kInstances, kOldScene}, 10000, [&](std::size_t, const std::string& text) {
        read({game.types, &library}, text);
    });
}

TEST_F(TypeSwap, propertyPrefabs) {
    std::vector<std::string> samples = textsOf(".prefab.json");
    samples.push_back(kPost);
    constexpr const char* kScene = R"({"format": 1, "effects": {}, "layers": [], "entities": [
        {"id": "a1", "prefab": "prefabs/post.prefab.json", "components": {"Transform": {"position": [1, 2]}}}]})";
    PrefabLibrary& library = lamps();
    eachTypeSwap(samples, 4000, [&](std::size_t, const std::string& text) {
        library.add(kPostPath, text);
        const Result<const Prefab*> prefab = library.find(kPostPath);
        if (!prefab) return expectReportedWell(prefab.error());
        expectReportedWell((*prefab)->problems);
        static_cast<void>(spawnPrefab(game.world, game.types, **prefab, {}));
        game.world.clear();
        read({game.types, &library}, kScene);
    });
}

TEST_F(TypeSwap, propertyTilesets) {
    eachTypeSwap(textsOf(".tileset.json"), 500, [](std::size_t, const std::string& text) {
        std::vector<Error> problems;
        const Result<Tileset> tileset = parseTileset(text, "swapped.tileset.json", problems);
        expectReportedWell(problems);
        if (!tileset) return expectReportedWell(tileset.error());
        EXPECT_TRUE(parseJson(writeTileset(*tileset), "written").ok());
    });
}

TEST_F(TypeSwap, propertyAnimations) {
    eachTypeSwap(textsOf(".anim.json"), 1500, [](std::size_t, const std::string& text) {
        std::vector<Error> problems;
        const Result<AnimationSet> set = parseAnimationSet(text, "swapped.anim.json", problems);
        expectReportedWell(problems);
        if (!set) return expectReportedWell(set.error());
        EXPECT_TRUE(parseJson(writeAnimationSet(*set), "written").ok());
    });
}

TEST_F(TypeSwap, propertyProjects) {
    eachTypeSwap(textsOf("project.json"), 4000, [](std::size_t, const std::string& text) {
        const Result<Project> project = projectFromText(text, "root", "project.json");
        if (!project) return expectReportedWell(project.error());
        expectReportedWell(project->warnings);
    });
}

TEST_F(TypeSwap, propertyReplays) {
    const std::string replay = *readFile(test::sourceFolder() / "tests/replay/platformer.replay");
    test::eachSwap<test::WordSwaps>({replay}, 500, [](std::size_t, const std::string& text) {
        const Result<Replay> read = parseReplay(text, "swapped.replay");
        if (!read) return expectReportedWell(read.error());
        EXPECT_TRUE(parseReplay(writeReplay(*read), "written").ok());
    });
}

// ---- files of other editors

constexpr const char* kTiledMap =
    R"({"type": "map", "version": "1.10", "orientation": "orthogonal", "width": 2,
 "height": 2, "tilewidth": 8, "tileheight": 8, "infinite": false, "backgroundcolor": "#102030",
 "properties": [{"name": "music", "type": "string", "value": "cave"}, {"name": "boss", "type": "class",
  "propertytype": "Boss", "value": {"lives": 3, "names": ["a", "b"]}}],
 "tilesets": [{"firstgid": 1, "name": "art", "image": "art.png", "imagewidth": 16, "imageheight": 16, "tilewidth": 8,
  "tileheight": 8, "tilecount": 4, "columns": 2, "spacing": 0, "margin": 0, "tileoffset": {"x": 1, "y": 2},
  "grid": {"orientation": "orthogonal", "width": 8, "height": 8}, "transformations": {"hflip": true},
  "tiles": [{"id": 0, "type": "wall", "animation": [{"tileid": 0, "duration": 100}, {"tileid": 1, "duration": 50}],
    "objectgroup": {"type": "objectgroup", "objects": [{"id": 1, "x": 0, "y": 0, "width": 8, "height": 8}]},
    "properties": [{"name": "hot", "type": "bool", "value": true}]}],
  "wangsets": [{"name": "dirt", "type": "corner", "tile": -1, "colors": [{"name": "dirt", "color": "#ff0000", "tile": 0,
    "probability": 1}], "wangtiles": [{"tileid": 2, "wangid": [0, 1, 0, 1, 0, 1, 0, 1]}]}]}],
 "layers": [
  {"type": "tilelayer", "id": 1, "name": "ground", "width": 2, "height": 2, "opacity": 0.5, "visible": true,
   "data": [1, 2, 3, 4]},
  {"type": "tilelayer", "id": 2, "name": "far", "width": 2, "height": 2, "encoding": "base64", "compression": "",
   "data": "AQAAAAIAAAADAAAABAAAAA=="},
  {"type": "tilelayer", "id": 3, "name": "chunked", "width": 2, "height": 2, "startx": 0, "starty": 0,
   "chunks": [{"x": 0, "y": 0, "width": 2, "height": 2, "data": [1, 2, 3, 4]}]},
  {"type": "group", "id": 4, "name": "all", "layers": [
   {"type": "imagelayer", "id": 5, "name": "sky", "image": "art.png", "parallaxx": 0.5, "repeatx": true},
   {"type": "objectgroup", "id": 6, "name": "things", "objects": [
    {"id": 1, "name": "box", "type": "Door", "x": 1, "y": 2, "width": 3, "height": 4, "rotation": 10, "visible": true},
    {"id": 2, "x": 1, "y": 2, "gid": 2, "width": 8, "height": 8},
    {"id": 3, "x": 1, "y": 2, "ellipse": true, "width": 8, "height": 8},
    {"id": 4, "x": 1, "y": 2, "point": true},
    {"id": 5, "x": 1, "y": 2, "polygon": [{"x": 0, "y": 0}, {"x": 4, "y": 0}, {"x": 4, "y": 4}]},
    {"id": 6, "x": 1, "y": 2, "polyline": [{"x": 0, "y": 0}, {"x": 4, "y": 0}]},
    {"id": 7, "x": 1, "y": 2, "width": 40, "height": 9, "text": {"text": "hello", "color": "#ffffff", "pixelsize": 9,
     "wrap": true}}]}]}]})";

constexpr const char* kSheet = R"({"frames": [
  {"filename": "a", "frame": {"x": 0, "y": 0, "w": 8, "h": 8}, "rotated": false, "trimmed": false,
   "spriteSourceSize": {"x": 0, "y": 0, "w": 8, "h": 8}, "sourceSize": {"w": 8, "h": 8}, "duration": 100},
  {"filename": "b", "frame": {"x": 8, "y": 0, "w": 6, "h": 8}, "rotated": true, "trimmed": true,
   "spriteSourceSize": {"x": 1, "y": 0, "w": 8, "h": 6}, "sourceSize": {"w": 8, "h": 8}, "duration": 50}],
 "meta": {"app": "https://www.aseprite.org/", "version": "1.3", "image": "art.png", "format": "RGBA8888",
  "size": {"w": 16, "h": 16}, "scale": "1", "layers": [{"name": "one"}],
  "frameTags": [{"name": "walk", "from": 0, "to": 1, "direction": "pingpong", "repeat": "2", "color": "#000000ff"}],
  "slices": [{"name": "hit", "keys": [{"frame": 0, "bounds": {"x": 1, "y": 1, "w": 4, "h": 4}}]}]}})";
constexpr const char* kNamedFrames =
    R"({"frames": {"a": {"frame": {"x": 0, "y": 0, "w": 8, "h": 8}, "duration": 100}},
 "meta": {"image": "art.png"}})";

/// A map whose tileset and object template are in separate files.
constexpr const char* kMapOfParts =
    R"({"type": "map", "orientation": "orthogonal", "width": 2, "height": 2, "tilewidth": 8, "tileheight": 8,
 "tilesets": [{"firstgid": 1, "source": "art.tsj"}], "layers": [
  {"type": "tilelayer", "id": 1, "name": "ground", "width": 2, "height": 2, "data": [1, 2, 3, 4]},
  {"type": "objectgroup", "id": 2, "name": "things", "objects": [
   {"id": 1, "x": 8, "y": 8, "gid": 1, "width": 8, "height": 8},
   {"id": 2, "x": 1, "y": 2, "template": "hero.tj"}]}]})";
constexpr const char* kTileset =
    R"({"type": "tileset", "name": "art", "image": "art.png", "imagewidth": 16, "imageheight": 16,
 "tilewidth": 8, "tileheight": 8, "tilecount": 4, "columns": 2, "spacing": 0, "margin": 0, "objectalignment": "top",
 "tilerendersize": "grid", "fillmode": "stretch", "tileoffset": {"x": 1, "y": 2},
 "tiles": [{"id": 0, "type": "wall", "x": 0, "y": 0, "width": 8, "height": 8, "probability": 0.5,
   "animation": [{"tileid": 0, "duration": 100}, {"tileid": 1, "duration": 50}],
   "objectgroup": {"type": "objectgroup", "objects": [{"id": 1, "x": 0, "y": 0, "width": 8, "height": 8, "rotation": 9},
    {"id": 2, "x": 4, "y": 4, "polygon": [{"x": 0, "y": 0}, {"x": 4, "y": 0}, {"x": 4, "y": 4}]},
    {"id": 3, "x": 4, "y": 4, "polyline": [{"x": 0, "y": 0}, {"x": 4, "y": 0}]},
    {"id": 4, "x": 1, "y": 1, "width": 6, "height": 4, "ellipse": true}]}}],
 "terrains": [{"name": "dirt", "tile": 0}],
 "wangsets": [{"name": "dirt", "type": "mixed", "tile": -1, "colors": [{"name": "dirt", "color": "#ff0000", "tile": 0,
   "probability": 1}], "wangtiles": [{"tileid": 2, "wangid": [0, 1, 0, 1, 0, 1, 0, 1]}]}]})";
constexpr const char* kTemplate = R"({"type": "template", "tileset": {"firstgid": 1, "source": "art.tsj"},
 "object": {"name": "hero", "type": "player", "gid": 2, "width": 8, "height": 8, "rotation": 45, "visible": true,
  "properties": [{"name": "lives", "type": "int", "value": 3}]}})";
constexpr const char* kTemplateXml = R"(<template><tileset firstgid="1" source="art.tsj"/>
 <object name="hero" type="player" gid="2" width="8" height="8" rotation="45" visible="1"><properties>
  <property name="lives" type="int" value="3"/></properties></object></template>)";

struct ImportSwap : TypeSwap {
    test::TemporaryFolder folder{test::memoryFolder()};
    const Path project = folder.path / "project";

    ImportSwap() {
        const Image picture{16, 16, std::vector<std::uint8_t>(16 * 16 * 4, 200)};
        EXPECT_TRUE(writeFile(folder.path / "art.png", *encodePng(picture)).ok());
        EXPECT_TRUE(writeFile(project / "project.json", "{}").ok());
        for (const char* name : {"meadow.tmx", "meadow.tsx", "meadow.png", "brook.tmx"})
            EXPECT_TRUE(
                writeFile(folder.path / name, *readFile(test::sourceFolder() / "tests/import/maps" / name))
                    .ok());
    }

    void write(const std::string& name, const std::string& text) const {
        EXPECT_TRUE(writeFile(folder.path / name, text).ok());
    }
    /// Writes each variant to the file `name` and imports `map`, which references it, or that file itself if
    /// `map` is empty.
    template <class Swaps = test::TypeSwaps>
    void import(const std::vector<std::string>& samples, const std::string& name, std::size_t usual,
                const std::string& map = "") {
        test::eachSwap<Swaps>(samples, usual, [&](std::size_t, const std::string& text) {
            std::ofstream{folder.path / name, std::ios::binary} << text;
            const Result<ImportReport> report =
                importFile(folder.path / (map.empty() ? name : map), {}, project);
            if (!report) return expectReportedWell(report.error());
            expectReportedWell(report->problems);
        });
    }
    static std::vector<std::string> samplesOf(std::initializer_list<std::string_view> endings) {
        std::vector<std::string> samples;
        for (const Path& file : test::foreignMaps(endings)) samples.push_back(*readFile(file));
        return samples;
    }
    void importMaps(std::initializer_list<std::string_view> endings, const std::string& name,
                    std::size_t usual) {
        import(samplesOf(endings), name, usual);
    }
};

TEST_F(ImportSwap, propertyTiledMaps) { import({kTiledMap}, "map.tmj", 80); }
TEST_F(ImportSwap, propertyTiledWorlds) { importMaps({".world"}, "all.world", 20); }
TEST_F(ImportSwap, propertyJsonOfUnknownKind) { importMaps({".world"}, "all.json", 20); }
TEST_F(ImportSwap, propertyLdtkProjects) { importMaps({"island.ldtk"}, "island.ldtk", 80); }
TEST_F(ImportSwap, propertyLdtkProjectsOfOthers) { importMaps({".ldtk"}, "other.ldtk", 10); }
TEST_F(ImportSwap, propertyAsepriteSheets) { import({kSheet, kNamedFrames}, "sheet.json", 100); }

TEST_F(ImportSwap, propertyTiledTilesetsAndTemplatesInJson) {
    write("parts.tmj", kMapOfParts);
    write("art.tsj", kTileset);
    write("hero.tj", kTemplate);
    import({kTileset}, "art.tsj", 60, "parts.tmj");
    write("art.tsj", kTileset);
    import({kTemplate}, "hero.tj", 40, "parts.tmj");
}

TEST_F(ImportSwap, propertyProjectsOfTiled) {
    constexpr const char* kProject = R"({"automappingRulesFile": "", "folders": ["."], "propertyTypes": [
        {"id": 1, "name": "Door", "type": "class", "color": "#ff0000", "drawFill": true, "useAs": ["object"], "members": [
         {"name": "locked", "type": "bool", "value": true}, {"name": "way", "type": "string", "propertyType": "Way", "value": "up"},
         {"name": "light", "type": "class", "propertyType": "Door", "value": {"far": 9}}]},
        {"id": 2, "name": "Way", "type": "enum", "storageType": "string", "values": ["up", "down"]}]})";
    write("map.tmj", kTiledMap);
    import({kProject}, "game.tiled-project", 100, "map.tmj");
}

// ---- XML files

TEST_F(ImportSwap, propertyAttributesOfTiledMaps) {
    import <AttributeSwaps>(samplesOf({"meadow.tmx", "brook.tmx", "forest.tmx", "sandbox.tmx"}), "map.tmx",
                            200);
}
TEST_F(ImportSwap, propertyAttributesOfTiledTilesets) {
    import <AttributeSwaps>(samplesOf({"meadow.tsx"}), "meadow.tsx", 100, "meadow.tmx");
}
TEST_F(ImportSwap, propertyAttributesOfTiledTemplates) {
    write("parts.tmj", kMapOfParts);
    write("art.tsj", kTileset);
    import <AttributeSwaps>({kTemplateXml}, "hero.tj", 60, "parts.tmj");
}

}  // namespace
}  // namespace plumb
