#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/register_components.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {

// Components must not be in an unnamed namespace.
namespace prefab_check {

/// A component with a field for a prefab that is only spawned.
struct Launcher {
    PrefabId shot;

    static void describe(TypeBuilder<Launcher>& type) {
        type.name("Launcher");
        type.field<&Launcher::shot>("shot");
    }
};

}  // namespace prefab_check

namespace {

constexpr const char* kPath = "scenes/level.scene.json";
constexpr const char* kLamp = "prefabs/lamp.prefab.json";

std::string fileOf(const std::string& entities) {
    return "{\"format\": 1, \"entities\": [" + entities + "]}";
}

std::string textOf(const std::vector<Error>& problems) {
    std::string text;
    for (const Error& problem : problems) text += problem.text() + "\n";
    return text;
}

struct PrefabCheck : testing::Test {
    TypeRegistry types;
    PrefabLibrary library{types};
    SceneContext context{types, &library};

    PrefabCheck() {
        registerSceneComponents(types);
        types.add<prefab_check::Launcher>();
        library.add("prefabs/bulb.prefab.json", fileOf(R"({"id": "10", "components": {"Transform": {}}},
            {"id": "11", "parent": "10", "components": {"Transform": {}, "Camera": {"follow": "10"}}})"));
    }

    /// Returns the problems of a prefab with these entities, one a line.
    std::string problemsOf(const std::string& entities) {
        library.add(kLamp, fileOf(entities));
        const Result<const Prefab*> prefab = library.find(kLamp);
        EXPECT_TRUE(prefab) << prefab.error().text();
        return textOf(library.takeProblems());
    }
    /// Returns the problems of a prefab whose only entity has this content.
    std::string problemsIn(const std::string& content) {
        return problemsOf(R"({"id": "1", )" + content + "}");
    }
    static std::string sceneOf(const std::string& entities) {
        return R"({"format": 1, "effects": {}, "layers": [], "entities": [)" + entities + "]}";
    }
    std::string problemsOfScene(const std::string& entities) {
        World world{types};
        const Result<LoadReport> report = loadScene(world, context, kPath, sceneOf(entities));
        return report ? textOf(report->problems) : report.error().text();
    }
};

TEST_F(PrefabCheck, everyFaultInTheContentIsOneProblemWithItsPlaceAndARemedy) {
    const std::pair<const char*, const char*> cases[] = {
        {R"("componets": {})",
         "entities[0].componets: an entity has no such key; it is kept unchanged; did you mean "
         "\"components\"?\n"},
        {R"("components": 5)", "entities[0].components: expected an object, found 5; write {} for none\n"},
        {R"("name": 5)", "entities[0].name: expected a string, found 5; write it in double quotes\n"},
        {R"("prefab": 5)",
         "entities[0].prefab: expected the path of a prefab, found 5; write e.g. "
         "\"prefabs/coin.prefab.json\"\n"},
        {R"("components": {"Sprit": {}})",
         "entities[0].Sprit: there is no component \"Sprit\"; it is kept unchanged; did you mean "
         "\"Sprite\"?\n"},
        {R"("components": {"SceneEntity": {}})",
         "entities[0].SceneEntity: there is no component \"SceneEntity\"; it is kept unchanged; check the "
         "spelling\n"},
        {R"("components": {"Sprite": 5})",
         "entities[0].Sprite: expected an object, found 5; write {} for the defaults\n"},
        {R"("components": {"Sprite": {"widht": 3}})",
         "entities[0].Sprite.widht: Sprite has no such field; it is kept unchanged; did you mean "
         "\"width\"?\n"},
        {R"("components": {"Sprite": {"width": "wide"}})",
         "entities[0].Sprite.width: expected a whole number, found \"wide\"; write a number without a point, "
         "e.g. 3\n"},
        {R"("components": {"Camera": {"follow": "99"}})",
         "entities[0].Camera.follow: no entity has the id \"99\"; write the id of an entity of this file, or "
         "null for no entity\n"}};
    for (const auto& [content, expected] : cases)
        EXPECT_EQ(problemsIn(content), std::string{kLamp} + ": " + expected) << content;
}

TEST_F(PrefabCheck, aValueOutsideItsRangeIsReportedWithTheValueThatIsUsed) {
    EXPECT_EQ(
        problemsIn(R"("components": {"Camera": {"zoom": -1}})"),
        "prefabs/lamp.prefab.json: entities[0].Camera.zoom: -1 is outside 0.01 to 100; using 0.01; write "
        "a value inside the range\n");
}

TEST_F(PrefabCheck, keysOfTheFileAreChecked) {
    library.add(kLamp, R"({"format": 1, "entites": [], "entities": [{"id": "1"}], "layers": []})");
    ASSERT_TRUE(library.find(kLamp));
    EXPECT_EQ(
        textOf(library.takeProblems()),
        "prefabs/lamp.prefab.json: entites: a prefab has no such key; it is kept unchanged; did you mean "
        "\"entities\"?\n");
}

TEST_F(PrefabCheck, valuesOfTheGameAndNotesOfImportersAreNoProblems) {
    EXPECT_EQ(problemsIn(R"("properties": {"mood": "grim"}, "tiled": {"class": "Lamp"}, "components": {})"),
              "");
}

TEST_F(PrefabCheck, referencesToAllPartsAreAcceptedAlsoToLaterOnesAndToPartsOfNestedPrefabs) {
    const std::string inner = hexText(combinedId(0x22, 0x11));
    const auto follow = [](const std::string& id, const std::string& target) {
        return R"({"id": ")" + id + R"(", "components": {"Transform": {}, "Camera": {"follow": ")" + target +
               R"("}}})";
    };
    EXPECT_EQ(problemsOf(follow("20", "21") + "," + follow("21", "20") + "," + follow("23", "1") +
                         R"(, {"id": "22", "prefab": "prefabs/bulb.prefab.json",
                              "children": {"0000000000000011": {"components": {"Camera": {"follow": "21"}}}}},)" +
                         follow("24", inner)),
              "");
    EXPECT_NE(problemsOf(follow("20", "22")).find("Camera.follow"), std::string::npos);
}

TEST_F(PrefabCheck, overridesOfANestedPrefabAreCheckedInTheFileThatHasThem) {
    const auto instance = [](const std::string& more) {
        return R"({"id": "20"}, {"id": "21", "prefab": "prefabs/bulb.prefab.json", )" + more + "}";
    };
    const std::pair<const char*, const char*> cases[] = {
        {R"("components": {"Camera": {"zom": 2}})", "entities[1].Camera.zom: "},
        {R"("without": ["Camra"])", "entities[1].without: \"Camra\" is not a component"},
        {R"("without": "Camera")", "entities[1].without: expected a list"},
        {R"("children": {"0000000000000011": {"components": {"Camera": {"zom": 2}}}})",
         "entities[1].children.0000000000000011.Camera.zom: "},
        {R"("children": {"0000000000000011": {"parent": "20"}})",
         "entities[1].children.0000000000000011.parent: an override has no such key"},
        {R"("children": {"0000000000000077": {"name": "x"}})",
         "entities[1].children.0000000000000077: the prefab has no such part"},
        {R"("children": {"11": {"name": "x"}})", "write \"0000000000000011\""}};
    for (const auto& [more, expected] : cases) {
        const std::string text = problemsOf(instance(more));
        EXPECT_NE(text.find(expected), std::string::npos) << more << " gives " << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
        EXPECT_EQ(text.substr(0, std::string_view{kLamp}.size()), kLamp);
    }
}

TEST_F(PrefabCheck, aProblemInANestedPrefabIsReportedOnceForItsOwnFile) {
    library.add("prefabs/bulb.prefab.json", fileOf(R"({"id": "10", "components": {"Sprit": {}}})"));
    for (const char* name : {"prefabs/a.prefab.json", "prefabs/b.prefab.json"})
        library.add(name, fileOf(R"({"id": "1"}, {"id": "2", "prefab": "prefabs/bulb.prefab.json"},
                                    {"id": "3", "prefab": "prefabs/bulb.prefab.json"})"));
    ASSERT_TRUE(library.find("prefabs/a.prefab.json"));
    ASSERT_TRUE(library.find("prefabs/b.prefab.json"));
    const std::vector<Error> problems = library.takeProblems();
    ASSERT_EQ(problems.size(), 1u) << textOf(problems);
    EXPECT_EQ(problems[0].where, "prefabs/bulb.prefab.json: entities[0].Sprit");
    EXPECT_TRUE((*library.find("prefabs/a.prefab.json"))->warnings.empty());
}

TEST_F(PrefabCheck, problemsAreTakenOnceUntilTheFileIsReadAgain) {
    EXPECT_NE(problemsIn(R"("components": {"Sprit": {}})"), "");
    ASSERT_TRUE(library.find(kLamp));
    EXPECT_EQ(textOf(library.takeProblems()), "") << "the file was not read again";
    library.forget();
    ASSERT_TRUE(library.find(kLamp));
    EXPECT_EQ(library.takeProblems().size(), 1u);
}

TEST_F(PrefabCheck, aFaultyPrefabHasItsOtherValues) {
    ASSERT_NE(problemsIn(R"("components": {"Transform": {"position": [3, 4]}, "Sprit": {}, "Sprite":
        {"width": "wide", "height": 7}})"),
              "");
    World world{types};
    const Entity lamp = spawnPrefab(world, types, **library.find(kLamp), {});
    EXPECT_EQ(lamp.get<Sprite>().height, 7);
    EXPECT_EQ(lamp.get<Sprite>().width, Sprite{}.width);
}

TEST_F(PrefabCheck, aSceneReportsItsPrefabsOnceAndAlsoThoseThatItsComponentsOnlyName) {
    library.add("prefabs/spark.prefab.json",
                fileOf(R"({"id": "1", "components": {"Sprite": {"widht": 3}}})"));
    library.add("prefabs/shot.prefab.json",
                fileOf(R"({"id": "1", "components": {"Launcher": {"shot": "prefabs/spark.prefab.json"}}})"));
    library.add(kLamp, fileOf(R"({"id": "1", "components": {"Sprit": {}}})"));
    const std::string scene = R"(
        {"id": "a1", "prefab": "prefabs/lamp.prefab.json"}, {"id": "a2", "prefab": "prefabs/lamp.prefab.json"},
        {"id": "a3", "components": {"Launcher": {"shot": "prefabs/shot.prefab.json"}}})";
    const std::string first = problemsOfScene(scene);
    EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 2) << first;
    EXPECT_NE(first.find("prefabs/lamp.prefab.json: entities[0].Sprit: "), std::string::npos) << first;
    EXPECT_NE(first.find("prefabs/spark.prefab.json: entities[0].Sprite.widht: "), std::string::npos)
        << "named by the prefab that the scene names: " << first;
    EXPECT_EQ(problemsOfScene(scene), "");
}

TEST_F(PrefabCheck, aNamedPrefabThatCannotBeReadIsReportedOnce) {
    library.add("prefabs/loop.prefab.json",
                fileOf(R"({"id": "1"}, {"id": "2", "prefab": "prefabs/loop.prefab.json"})"));
    const std::string scene =
        R"({"id": "a3", "components": {"Launcher": {"shot": "prefabs/loop.prefab.json"}}})";
    EXPECT_EQ(problemsOfScene(scene),
              "prefabs/loop.prefab.json: entities[1].prefab: prefabs/loop.prefab.json: the prefab contains "
              "itself, through prefabs/loop.prefab.json; remove it from one of the two\n");
    EXPECT_EQ(problemsOfScene(scene), "");
}

TEST_F(PrefabCheck, theDepthLimitIsTheSameWhateverWasReadBefore) {
    const auto name = [](int level) { return format("prefabs/level{}.prefab.json", level); };
    for (int level = 1; level <= 20; ++level) {
        const std::string inner =
            level == 1 ? std::string{} : R"(, {"id": "2", "prefab": ")" + name(level - 1) + R"("})";
        library.add(name(level), fileOf(R"({"id": "1"})" + inner));
    }
    std::vector<bool> readAlone;
    for (int level = 1; level <= 20; ++level) {
        library.forget();
        readAlone.push_back(library.find(name(level)).ok());
    }
    library.forget();
    for (int level = 1; level <= 20; ++level)
        EXPECT_EQ(library.find(name(level)).ok(), readAlone[static_cast<std::size_t>(level - 1)]) << level;
    EXPECT_TRUE(readAlone[15]);
    EXPECT_FALSE(readAlone[16]);
}

struct PrefabNames : PrefabCheck {
    test::TemporaryFolder folder;
    PrefabLibrary files{types, folder.path};

    void put(const std::string& path) {
        ASSERT_TRUE(writeFile(folder.path / path, fileOf(R"({"id": "1"})")).ok());
    }
};

TEST_F(PrefabNames, aNameMayLackItsFolderAndItsEnding) {
    put("root.prefab.json");
    put("prefabs/both.prefab.json");
    put("assets/both.prefab.json");
    put("assets/coin.prefab.json");
    put("prefabs/toys/ball.prefab.json");
    const std::pair<const char*, const char*> names[] = {
        {"root", "root.prefab.json"},
        {"both", "prefabs/both.prefab.json"},
        {"both.prefab.json", "prefabs/both.prefab.json"},
        {"coin", "assets/coin.prefab.json"},
        {"coin.prefab.json", "assets/coin.prefab.json"},
        {"prefabs/toys/ball", "prefabs/toys/ball.prefab.json"},
        {"prefabs/both.prefab.json", "prefabs/both.prefab.json"},
        {"none", "prefabs/none.prefab.json"}};
    for (const auto& [name, path] : names) EXPECT_EQ(files.pathOf(name), path) << name;
    ASSERT_NE(files.named("prefabs/toys/ball"), nullptr);
    EXPECT_EQ(files.named("prefabs/toys/ball"), files.named("prefabs/toys/ball.prefab.json"));
}

TEST_F(PrefabNames, theErrorOfAMissingPrefabNamesTheNearestFile) {
    put("prefabs/coin.prefab.json");
    put("prefabs/toys/ball.prefab.json");
    put(".plumb/backups/prefabs/bal.prefab.json");
    const auto errorOf = [this](const char* path) { return files.find(path).error().text(); };
    EXPECT_EQ(errorOf("prefabs/bal.prefab.json"),
              "prefabs/bal.prefab.json: there is no such file; did you mean "
              "\"prefabs/toys/ball.prefab.json\"?");
    EXPECT_EQ(errorOf("assets/coin.prefab.json"),
              "assets/coin.prefab.json: there is no such file; did you mean \"prefabs/coin.prefab.json\"?");
    EXPECT_EQ(errorOf("prefabs/dragon.prefab.json"),
              "prefabs/dragon.prefab.json: there is no such file; check the name, or put the file there");
}

TEST_F(PrefabNames, aMissingNestedPrefabIsReportedWithItsPlace) {
    put("prefabs/coin.prefab.json");
    ASSERT_TRUE(writeFile(folder.path / "prefabs/bag.prefab.json",
                          fileOf(R"({"id": "1"}, {"id": "2", "prefab": "prefabs/coins.prefab.json"})")));
    EXPECT_EQ(
        files.find("prefabs/bag.prefab.json").error().text(),
        "prefabs/bag.prefab.json: entities[1].prefab: prefabs/coins.prefab.json: there is no such file; "
        "did you mean \"prefabs/coin.prefab.json\"?");
}

TEST_F(PrefabNames, aFileThatAppearsIsFound) {
    ASSERT_FALSE(files.find("prefabs/late.prefab.json"));
    put("prefabs/late.prefab.json");
    EXPECT_TRUE(files.find("prefabs/late.prefab.json"));
}

}  // namespace
}  // namespace plumb
