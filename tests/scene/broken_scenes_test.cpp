#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ecs/world.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/files/world_field_context.hpp"
#include "scene/register_components.hpp"

namespace plumb {
namespace {

constexpr const char* kPath = "scenes/broken.scene.json";

/// A broken scene file and the error that must be reported for it.
struct Case {
    const char* name;
    std::string text;
    const char* where;       ///< expected location in the error
    const char* what;        ///< expected text in the error
    int loaded;              ///< number of entities that load; -1 if the file cannot be loaded at all
    const char* stays = "";  ///< text that saving must preserve
};

std::string scene(const std::string& entities, const std::string& head = "") {
    return "{\"format\": 1, \"effects\": {}, \"layers\": [], " + head + "\"entities\": [" + entities + "]}";
}

/// Returns a scene with the entity between two valid ones, which must load.
std::string among(const std::string& entity) {
    return scene(R"({"id": "a1", "name": "first", "components": {"Transform": {"position": [1, 2]}}}, )" +
                 entity + R"(, {"id": "a3", "name": "last", "components": {"Transform": {}}})");
}

std::string withComponent(const std::string& component) {
    return among(R"({"id": "a2", "components": {)" + component + "}}");
}

std::string nested(int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
}

std::vector<Case> wholeFileCases() {
    return {
        {"empty", "", "broken.scene.json", "expected", -1},
        {"blank", "  \n ", "broken.scene.json", "expected", -1},
        {"truncated in a text", R"({"format": 1, "ent)", "broken.scene.json", "no end", -1},
        {"truncated in an entity", R"({"format": 1, "entities": [{"id": "a1", )", "broken.scene.json",
         "expected", -1},
        {"no object", "[1, 2]", "broken.scene.json", "expected a scene, found a list of 2", -1},
        {"a number", "42", "broken.scene.json", "expected a scene, found 42", -1},
        {"a text", "\"hello\"", "broken.scene.json", "expected a scene", -1},
        {"no JSON", "hello world", "broken.scene.json:1:1", "expected a value", -1},
        {"comments", "// scene\n{}", "broken.scene.json:1:1", "expected a value", -1},
        {"a comma too much", R"({"format": 1, "entities": [],})", "broken.scene.json",
         "expected a property's name", -1},
        {"a missing comma", R"({"format": 1 "entities": []})", "broken.scene.json", "expected \",\"", -1},
        {"something behind the end", R"({"format": 1, "entities": []} x)", "broken.scene.json",
         "expected the end", -1},
        {"not UTF-8", "{\"format\": 1, \"name\": \"\xff\xfe\", \"entities\": []}", "broken.scene.json",
         "UTF-8", -1},
        {"raw zero bytes", std::string("{\"format\": 1\0}", 14), "broken.scene.json", "expected", -1},
        {"nested too deep", R"({"format": 1, "x": )" + nested(100) + "}", "broken.scene.json",
         "nested deeper than 64", -1},
        {"very deep", std::string(200000, '['), "broken.scene.json", "nested deeper", -1},
        {"newer format", R"({"format": 2, "entities": []})", ": format", "expected 0 to 1, found 2", -1},
        {"format of a wrong kind", R"({"format": "one", "entities": []})", ": format", "found \"one\"", -1},
        {"negative format", R"({"format": -1, "entities": []})", ": format", "found -1", -1},
        {"a key twice", R"({"format": 1, "format": 1, "entities": []})", "broken.scene.json", "appears twice",
         -1},
        {"entities of a wrong kind", R"({"format": 1, "entities": {}})", "broken.scene.json",
         "is not a JSON array", -1},
        {"format missing", R"({"entities": []})", "format", "the key is missing", 0},
        {"entities missing", R"({"format": 1})", "entities", "the key is missing", 0},
        {"unknown key", scene("", R"("weather": "rain", )"), "weather", "no such key", 0,
         "\"weather\": \"rain\""},
        {"effects of a wrong kind", R"({"format": 1, "effects": 3, "entities": []})", "effects", "found 3", 0,
         "\"effects\": 3"},
        {"layers of a wrong kind", R"({"format": 1, "layers": "many", "entities": []})", "layers",
         "expected a list", 0, "\"layers\": \"many\""},
        {"a layer of a wrong kind", R"({"format": 1, "layers": [7], "entities": []})", "layers[0]",
         "expected an object", 0, "7"},
        {"unknown field of a layer",
         R"({"format": 1, "layers": [{"name": "sky", "hue": 3}], "entities": []})", "layers[0].hue",
         "no such field", 0, "\"hue\": 3"},
        {"wrong field of a layer",
         R"({"format": 1, "layers": [{"name": "sky", "order": "top"}], "entities": []})", "layers[0].order",
         "found \"top\"", 0, "\"order\": \"top\""},
    };
}

std::vector<Case> entityCases() {
    return {
        {"a number", among("7"), "entities[1]", "expected an object, found 7", 2, "7"},
        {"null", among("null"), "entities[1]", "expected an object, found null", 2, "null"},
        {"broken inside", among(R"({"id": "a2", "components": {"Transform": {"rotation": }}})"),
         ":1:", "expected a value", 2, R"({"id": "a2", "components": {"Transform": {"rotation": }}})"},
        {"NaN as a word", among(R"({"id": "a2", "components": {"Transform": {"rotation": NaN}}})"),
         ":1:", "expected a value", 2, "NaN"},
        {"a number too large", among(R"({"id": "a2", "components": {"Transform": {"rotation": 1e999}}})"),
         ":1:", "too large for a double", 2, "1e999"},
        {"bad UTF-8", among("{\"id\": \"a2\", \"name\": \"\xc3\x28\"}"), ":1:", "UTF-8", 2, "\xc3\x28"},
        {"a bad escape", among(R"({"id": "a2", "name": "\q"})"), ":1:", "expected an escape", 2, R"(\q)"},
        {"no id", among(R"({"name": "nothing"})"), "entities[1]", "has no id", 3, "\"name\": \"nothing\""},
        {"an id that is a number", among(R"({"id": 7})"), "entities[1].id", "found 7", 2, "7"},
        {"an id that is no hex", among(R"({"id": "player"})"), "entities[1].id", "found \"player\"", 2,
         "\"player\""},
        {"the id zero", among(R"({"id": "0"})"), "entities[1].id", "expected 16 hex digits", 2,
         "{\"id\": \"0\"}"},
        {"a duplicate id", among(R"({"id": "a1", "name": "twin"})"), "entities[1].id",
         "another entity has the id", 2, "\"twin\""},
        {"a key twice", among(R"({"id": "a2", "name": "x", "name": "y"})"), ":1:", "appears twice", 2,
         R"("name": "x", "name": "y")"},
        {"unknown key", among(R"({"id": "a2", "colour": "red"})"), "entities[1].colour", "no such key", 3,
         "\"colour\": \"red\""},
        {"name of a wrong kind", among(R"({"id": "a2", "name": 7})"), "entities[1].name", "expected a string",
         3, "\"name\": 7"},
        {"components of a wrong kind", among(R"({"id": "a2", "components": []})"), "entities[1].components",
         "expected an object", 3, "\"components\": []"},
        {"unknown parent", among(R"({"id": "a2", "parent": "ff"})"), "entities[1].parent",
         "no entity has the id", 3, "\"parent\": \"ff\""},
        {"parent of a wrong kind", among(R"({"id": "a2", "parent": 12})"), "entities[1].parent",
         "no entity has the id 12", 3, "\"parent\": 12"},
        {"itself as parent", among(R"({"id": "a2", "parent": "a2"})"), "entities[1].parent", "form a cycle",
         3, "\"parent\": \"a2\""},
        {"a circle of parents",
         scene(R"({"id": "a1", "parent": "a2"}, {"id": "a2", "parent": "a3"}, {"id": "a3", "parent": "a1"})"),
         "entities[2].parent", "form a cycle", 3, "\"parent\": \"a1\""},
        {"unknown component", withComponent(R"("Spinn": {"rate": 2})"), "entities[1].Spinn",
         "no component \"Spinn\"", 3, "\"rate\": 2"},
        {"a component of the file", withComponent(R"("SceneEntity": {"id": 4})"), "entities[1].SceneEntity",
         "no component", 3, "\"SceneEntity\""},
        {"component of a wrong kind", withComponent(R"("Sprite": 3)"), "entities[1].Sprite",
         "expected an object, found 3", 3, "\"Sprite\": 3"},
        {"a prefab without library file", among(R"({"id": "a2", "prefab": "prefabs/none.prefab.json"})"),
         "entities[1].prefab", "no such prefab", 2, "none.prefab.json"},
        {"prefab of a wrong kind", among(R"({"id": "a2", "prefab": 5})"), "entities[1].prefab",
         "expected the path", 2, "\"prefab\": 5"},
        {"a prefab that holds itself", among(R"({"id": "a2", "prefab": "prefabs/loop.prefab.json"})"),
         "entities[1].prefab", "contains itself", 2, "loop.prefab.json"},
        {"two prefabs in a circle", among(R"({"id": "a2", "prefab": "prefabs/ping.prefab.json"})"),
         "entities[1].prefab", "contains itself", 2, "ping.prefab.json"},
        {"an empty prefab", among(R"({"id": "a2", "prefab": "prefabs/empty.prefab.json"})"),
         "entities[1].prefab", "at least one entity", 2, "empty.prefab.json"},
        {"a broken prefab", among(R"({"id": "a2", "prefab": "prefabs/broken.prefab.json"})"),
         "entities[1].prefab", "expected", 2, "broken.prefab.json"},
        {"a newer prefab", among(R"({"id": "a2", "prefab": "prefabs/newer.prefab.json"})"),
         "entities[1].prefab", "found 9", 2, "newer.prefab.json"},
        {"a prefab with a bad part", among(R"({"id": "a2", "prefab": "prefabs/part.prefab.json"})"),
         "part.prefab.json: entities[1].id", "the id is missing", 3, "part.prefab.json"},
        {"overrides of no part",
         among(R"({"id": "a2", "prefab": "prefabs/coin.prefab.json", "children": {"77": {"name": "x"}}})"),
         "entities[1].children.77", "no such part", 3, "\"77\""},
        {"without a non-component",
         among(R"({"id": "a2", "prefab": "prefabs/coin.prefab.json", "without": "Sprite"})"),
         "entities[1].without", "expected a list", 3, "\"without\": \"Sprite\""},
    };
}

std::vector<Case> fieldCases() {
    return {
        {"unknown field", withComponent(R"("Transform": {"positoin": [1, 2]})"), "Transform.positoin",
         "no such field", 3, "\"positoin\": [1, 2]"},
        {"a field that is not saved", withComponent(R"("Transform": {"previousRotation": 1})"),
         "Transform.previousRotation", "no such field", 3, "\"previousRotation\": 1"},
        {"text for a number", withComponent(R"("Transform": {"rotation": "fast"})"), "Transform.rotation",
         "found \"fast\"", 3, "\"rotation\": \"fast\""},
        {"NaN as a text", withComponent(R"("Transform": {"position": ["NaN", 0]})"), "Transform.position[0]",
         "expected a number, found \"NaN\"", 3, "[\"NaN\", 0]"},
        {"too large for a float", withComponent(R"("Transform": {"rotation": 1e300})"), "Transform.rotation",
         "expected a finite number", 3, "\"rotation\": 1e+300"},
        {"three numbers for two", withComponent(R"("Transform": {"position": [1, 2, 3]})"),
         "Transform.position", "expected [x, y], found a list of 3", 3, "[1, 2, 3]"},
        {"null for a place", withComponent(R"("Transform": {"position": null})"), "Transform.position",
         "found null", 3, "\"position\": null"},
        {"number for a truth", withComponent(R"("Sprite": {"flipX": 1})"), "Sprite.flipX",
         "expected true or false", 3, "\"flipX\": 1"},
        {"half a pixel", withComponent(R"("Sprite": {"width": 2.5})"), "Sprite.width",
         "expected a whole number, found 2.5", 3, "\"width\": 2.5"},
        {"negative size", withComponent(R"("Sprite": {"width": -4})"), "Sprite.width",
         "-4 is outside 0 to 16384", 3, "\"width\": -4"},
        {"a color by name", withComponent(R"("Sprite": {"tint": "red"})"), "Sprite.tint", "expected a color",
         3, "\"tint\": \"red\""},
        {"a path that climbs out", withComponent(R"("Sprite": {"texture": "../../secret.png"})"),
         "Sprite.texture", "leaves the project", 3, "../../secret.png"},
        {"an absolute path", withComponent(R"("Sprite": {"texture": "/etc/passwd"})"), "Sprite.texture",
         "leaves the project", 3, "/etc/passwd"},
        {"a drive", withComponent(R"("Sprite": {"texture": "C:/x.png"})"), "Sprite.texture",
         "leaves the project", 3, "C:/x.png"},
        {"back slashes", withComponent(R"("Sprite": {"texture": "assets\\x.png"})"), "Sprite.texture",
         "leaves the project", 3, R"(assets\\x.png)"},
        {"a number for a path", withComponent(R"("Sprite": {"texture": 9})"), "Sprite.texture",
         "expected the path of a file", 3, "\"texture\": 9"},
        {"an unknown name of an enum", withComponent(R"("Label": {"align": "centre"})"), "Label.align",
         "found \"centre\"", 3, "\"align\": \"centre\""},
        {"a reference to nothing", withComponent(R"("Camera": {"follow": "abcdef"})"), "Camera.follow",
         "no entity has the id", 3, "\"follow\": \"abcdef\""},
        {"a reference by name", withComponent(R"("Camera": {"follow": "player"})"), "Camera.follow",
         "expected the id of an entity", 3, "\"follow\": \"player\""},
        {"a ratio past its range", withComponent(R"("RigidBody": {"bounciness": 3})"), "RigidBody.bounciness",
         "3 is outside 0 to 1", 3, "\"bounciness\": 3"},
        {"ragged rows",
         withComponent(R"("TileLayer": {"cells": {"width": 2, "height": 2, "rows": ["1 2", "3"]}})"),
         "TileLayer.cells", "1 of 2 rows do not have 2 tiles", 3, "\"3\""},
        {"too few rows",
         withComponent(R"("TileLayer": {"cells": {"width": 2, "height": 3, "rows": ["1 2"]}})"),
         "TileLayer.cells", "found 1 rows, the height is 3", 3, "\"height\": 3"},
        {"letters in a row",
         withComponent(R"("TileLayer": {"cells": {"width": 2, "height": 1, "rows": ["1 q"]}})"),
         "TileLayer.cells.rows[0]", "expected tile numbers", 3, "\"1 q\""},
        {"a row that is a number",
         withComponent(R"("TileLayer": {"cells": {"width": 1, "height": 1, "rows": [1]}})"),
         "TileLayer.cells.rows[0]", "found 1", 3, "[1]"},
        {"rows missing", withComponent(R"("TileLayer": {"cells": {"width": 1, "height": 1}})"),
         "TileLayer.cells.rows", "found nothing", 3, "\"cells\""},
        {"a huge grid",
         withComponent(R"("TileLayer": {"cells": {"width": 99999999, "height": 1, "rows": []}})"),
         "TileLayer.cells.width", "found 99999999", 3, "99999999"},
        {"a negative grid",
         withComponent(R"("TileLayer": {"cells": {"width": -1, "height": 1, "rows": []}})"),
         "TileLayer.cells.width", "found -1", 3, "-1"},
        {"tiles past the memory",
         withComponent(R"("TileLayer": {"cells": {"width": 16384, "height": 16384, "rows": []}})"),
         "TileLayer.cells.width", "tiles exceed the limit", 3, "16384"},
        {"damaged base64",
         withComponent(R"("TileLayer": {"cells": {"width": 2, "height": 2, "base64": ["!!!!"]}})"),
         "TileLayer.cells.base64[0]", "damaged", 3, "!!!!"},
        {"base64 of another size",
         withComponent(R"("TileLayer": {"cells": {"width": 2, "height": 2, "base64": []}})"),
         "TileLayer.cells.base64", "expected a list of 1", 3, "\"base64\": []"},
        {"tiles of a wrong kind", withComponent(R"("TileLayer": {"cells": "grass"})"), "TileLayer.cells",
         "expected an object", 3, "\"grass\""},
    };
}

struct BrokenScenes : testing::Test {
    TypeRegistry types;
    PrefabLibrary prefabs{types};
    SceneContext context{types, &prefabs};

    BrokenScenes() {
        registerSceneComponents(types);
        const auto give = [this](const char* name, const char* entities) {
            prefabs.add(std::string{"prefabs/"} + name + ".prefab.json",
                        std::string{"{\"format\": 1, \"entities\": ["} + entities + "]}");
        };
        give("coin",
             R"({"id": "c1", "name": "coin", "components": {"Transform": {}, "Sprite": {"width": 8}}})");
        give("loop", R"({"id": "c1", "prefab": "prefabs/loop.prefab.json"})");
        give("ping", R"({"id": "c1"}, {"id": "c2", "prefab": "prefabs/pong.prefab.json"})");
        give("pong", R"({"id": "c1"}, {"id": "c2", "prefab": "prefabs/ping.prefab.json"})");
        give("empty", "");
        give("broken", R"({"id": )");
        give("part", R"({"id": "c1"}, {"name": "no id"})");
        prefabs.add("prefabs/newer.prefab.json", R"({"format": 9, "entities": [{"id": "c1"}]})");
    }

    void check(const Case& broken) {
        SCOPED_TRACE(broken.name);
        World world{types};
        const auto report = loadScene(world, context, kPath, broken.text);
        const Error* error = nullptr;
        if (broken.loaded < 0) {
            ASSERT_FALSE(report);
            error = &report.error();
            EXPECT_EQ(world.entityCount(), 0u);
        } else {
            ASSERT_TRUE(report) << report.error().text();
            for (const Error& problem : report->problems)
                EXPECT_EQ(&problem, report->problems.data()) << problem.text();
            ASSERT_EQ(report->problems.size(), 1u);
            error = &report->problems.front();
            EXPECT_EQ(report->loaded, static_cast<std::size_t>(broken.loaded));
        }
        EXPECT_NE(error->where.find(broken.where), std::string::npos) << error->text();
        EXPECT_NE(error->what.find(broken.what), std::string::npos) << error->text();
        EXPECT_FALSE(error->remedy.empty()) << error->text();
        if (broken.loaded >= 0) checkNothingIsLost(world, broken);
    }

    /// Expects that saving preserves the broken text and that the saved file reports the same when it is
    /// loaded.
    void checkNothingIsLost(World& world, const Case& broken) {
        const std::string saved = sceneToJson(world, context, sceneId(kPath));
        EXPECT_NE(saved.find(broken.stays), std::string::npos) << saved;
        World again{types};
        const auto report = loadScene(again, context, kPath, saved);
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->loaded, static_cast<std::size_t>(broken.loaded));
        EXPECT_EQ(sceneToJson(again, context, sceneId(kPath)), saved);
    }
};

TEST_F(BrokenScenes, anInvalidSceneFileIsOneErrorAndChangesNothing) {
    for (const Case& broken : wholeFileCases()) check(broken);
}

TEST_F(BrokenScenes, aBrokenEntityIsOneErrorAndTheOthersLoad) {
    for (const Case& broken : entityCases()) check(broken);
}

TEST_F(BrokenScenes, aBrokenFieldIsOneErrorAndKeepsItsDefault) {
    for (const Case& broken : fieldCases()) check(broken);
}

TEST_F(BrokenScenes, thereAreAtLeastSixtyCases) {
    EXPECT_GE(wholeFileCases().size() + entityCases().size() + fieldCases().size(), 60u);
}

TEST_F(BrokenScenes, aRepairedValueReplacesTheBrokenOne) {
    World world{types};
    ASSERT_TRUE(loadScene(world, context, kPath, withComponent(R"("Transform": {"rotation": "fast"})")));
    for (auto [entity, transform] : world.query<Transform>()) transform.rotation = 0.5f;

    const std::string saved = sceneToJson(world, context, sceneId(kPath));
    EXPECT_EQ(saved.find("fast"), std::string::npos);
}

TEST_F(BrokenScenes, aSkippedEntityKeepsItsTextAndPosition) {
    const std::string broken = "{\n      \"id\": \"a2\",\n      \"x\": NaN\n    }";
    World world{types};
    ASSERT_TRUE(loadScene(world, context, kPath, among(broken)));

    const std::string saved = sceneToJson(world, context, sceneId(kPath));
    const std::size_t at = saved.find(broken);
    ASSERT_NE(at, std::string::npos);
    EXPECT_LT(saved.find("\"first\""), at);
    EXPECT_GT(saved.find("\"last\""), at);
}

TEST_F(BrokenScenes, anOlderFormatIsUpgraded) {
    World world{types};
    const auto report =
        loadScene(world, context, kPath,
                  R"({"format": 0, "entities": [{"id": "a1", "position": [3, 4], "components": {}}]})");

    ASSERT_TRUE(report);
    EXPECT_TRUE(report->problems.empty());
    EXPECT_EQ(world.get<Transform>(findById(world, 0xa1)).position, (Vec2{3.0f, 4.0f}));
    EXPECT_NE(sceneToJson(world, context, sceneId(kPath)).find("\"format\": 1"), std::string::npos);
}

}  // namespace
}  // namespace plumb
