// Values of a wrong type that crashed earlier versions of the program.

#include <stdexcept>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/guarded.hpp"
#include "ecs/world.hpp"
#include "import/import_file.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/register_components.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

constexpr const char* kPath = "scenes/level.scene.json";

struct WrongTypes : testing::Test {
    TypeRegistry types;
    PrefabLibrary library{types};
    SceneContext context{types, &library};
    World world{types};

    WrongTypes() {
        registerSceneComponents(types);
        library.add("prefabs/lamp.prefab.json", R"({"format": 1, "entities": [
            {"id": "10", "components": {"Transform": {}}},
            {"id": "2", "parent": "10", "components": {"Transform": {}}}]})");
    }
    static std::string instanceWith(const std::string& part) {
        return R"({"format": 1, "effects": {}, "layers": [], "entities": [{"id": "a1", "prefab":
            "prefabs/lamp.prefab.json", "children": {"0000000000000002": )" +
               part + "}}]}";
    }
    /// Expects one problem that contains these texts.
    void expectReported(const std::vector<Error>& problems, const char* where, const char* what) {
        ASSERT_EQ(problems.size(), 1u);
        EXPECT_NE(problems[0].where.find(where), std::string::npos) << problems[0].text();
        EXPECT_NE(problems[0].what.find(what), std::string::npos) << problems[0].text();
        EXPECT_FALSE(problems[0].remedy.empty());
    }
};

TEST_F(WrongTypes, aPartWhoseRemovedIsANumberStaysAndTheFileKeepsTheValue) {
    const Result<LoadReport> report = loadScene(world, context, kPath, instanceWith(R"({"removed": 5})"));
    ASSERT_TRUE(report);
    expectReported(report->problems, "children.0000000000000002.removed", "found 5");
    EXPECT_EQ(world.entityCount(), 2u);
    EXPECT_NE(sceneToJson(world, context, sceneId(kPath)).find("\"removed\": 5"), std::string::npos);
}

TEST_F(WrongTypes, aPartWhoseRemovedIsFalseIsValidAndTheFileKeepsTheValue) {
    const Result<LoadReport> report = loadScene(world, context, kPath, instanceWith(R"({"removed": false})"));
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->problems.empty());
    EXPECT_EQ(world.entityCount(), 2u);
    EXPECT_NE(sceneToJson(world, context, sceneId(kPath)).find("\"removed\": false"), std::string::npos);
}

TEST_F(WrongTypes, anOverrideThatIsNotAnObjectIsIgnored) {
    const Result<LoadReport> report = loadScene(world, context, kPath, instanceWith("5"));
    ASSERT_TRUE(report);
    expectReported(report->problems, "children.0000000000000002", "found 5");
    EXPECT_EQ(world.entityCount(), 2u);
}

TEST_F(WrongTypes, aNestedPrefabWithAnInvalidOverrideIsReadPartially) {
    const auto post = [&](const std::string& children) {
        library.add("prefabs/post.prefab.json", R"({"format": 1, "entities": [
            {"id": "20", "components": {"Transform": {}}},
            {"id": "21", "prefab": "prefabs/lamp.prefab.json", "children": )" +
                                                    children + "}]}");
        return library.find("prefabs/post.prefab.json");
    };
    const std::tuple<const char*, const char*, const char*> kinds[] = {
        {R"({"0000000000000002": {"removed": 5}})", "children.0000000000000002.removed", "found 5"},
        {R"({"0000000000000002": "gone"})", "children.0000000000000002", "found \"gone\""},
        {"5", "children", "found 5"},
    };
    for (const auto& [children, where, what] : kinds) {
        SCOPED_TRACE(children);
        const Result<const Prefab*> prefab = post(children);
        ASSERT_TRUE(prefab);
        EXPECT_EQ((*prefab)->entities.size(), 3u);
        expectReported((*prefab)->problems, where, what);
    }
}

TEST_F(WrongTypes, anOldSceneWhoseTransformIsNotAnObjectLoads) {
    const Result<LoadReport> report = loadScene(world, context, kPath, R"({"format": 0, "effects": {},
        "layers": [], "entities": [{"id": "a1", "position": [3, 4], "components": {"Transform": 5}}]})");
    ASSERT_TRUE(report);
    EXPECT_EQ(report->loaded, 1u);
}

struct WrongTypesInImports : testing::Test {
    test::TemporaryFolder folder;

    Result<ImportReport> import(const std::string& name, const std::string& text) {
        EXPECT_TRUE(writeFile(folder.path / "project/project.json", "{}").ok());
        EXPECT_TRUE(writeFile(folder.path / name, text).ok());
        return importFile(folder.path / name, {}, folder.path / "project");
    }
    void expectRefused(const std::string& name, const std::string& text, const char* what) {
        SCOPED_TRACE(text);
        const Result<ImportReport> report = import(name, text);
        ASSERT_FALSE(report);
        EXPECT_NE(report.error().what.find(what), std::string::npos) << report.error().text();
        EXPECT_FALSE(report.error().where.empty());
        EXPECT_FALSE(report.error().remedy.empty());
    }
};

TEST_F(WrongTypesInImports, aSheetWithoutFramesIsRejected) {
    for (const char* frames : {"5", "true", "\"a\"", "null", "[]", "{}"}) {
        std::string text = "{\"frames\": ";
        text.append(frames).append(
            R"(, "meta": {"image": "hero.png", "frameTags": [{"name": "walk", "to": 2}]}})");
        expectRefused("hero.json", text, "not an Aseprite sheet");
    }
}

TEST_F(WrongTypesInImports, aWorldFileWhoseTypeIsANumberIsRejected) {
    expectRefused("all.json", R"({"maps": [], "type": 5})", "this kind of file cannot be imported");
}

TEST_F(WrongTypesInImports, chunksThatAreNotAnArrayAreIgnored) {
    for (const char* chunks : {"5", "{\"data\": [1]}", "\"x\""}) {
        SCOPED_TRACE(chunks);
        std::string text = R"({"type": "map", "orientation": "orthogonal", "width": 1, "height": 1,
            "tilewidth": 8, "tileheight": 8, "layers": [{"type": "tilelayer", "name": "a", "width": 1,
            "height": 1, "chunks": )";
        const Result<ImportReport> report = import("map.tmj", text.append(chunks).append("}]}"));
        EXPECT_TRUE(report.ok()) << report.error().text();
    }
}

TEST_F(WrongTypesInImports, tagsAndDataOfTilesThatAreNotStringsAreReportedAndIgnored) {
    std::string text = *readFile(test::sourceFolder() / "tests/import/maps/island.ldtk");
    for (const std::string_view value : {"\"hot\"", "\"Lava\""}) {
        const std::size_t at = text.find(value);
        ASSERT_NE(at, std::string::npos);
        text = text.substr(0, at).append("5").append(text, at + value.size());
    }
    const Result<ImportReport> report = import("island.ldtk", text);
    ASSERT_TRUE(report) << report.error().text();
    int reported = 0;
    for (const Error& problem : report->problems) {
        const bool tags = problem.where.find("enumTags") != std::string::npos;
        const bool ofTiles = problem.where.find("customData") != std::string::npos;
        reported += tags || ofTiles ? 1 : 0;
    }
    EXPECT_EQ(reported, 2);
}

TEST(Guarded, anExceptionInAReaderBecomesAnErrorWithTheFileName) {
    const Result<int> read = guarded("a.json", []() -> Result<int> { throw std::runtime_error{"bad type"}; });
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().where, "a.json");
    EXPECT_NE(read.error().what.find("bad type"), std::string::npos);
    EXPECT_FALSE(read.error().remedy.empty());
    EXPECT_EQ(*guarded("a.json", []() -> Result<int> { return 3; }), 3);
}

}  // namespace
}  // namespace plumb
