#include <plumb.hpp>
#include <regex>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "app/game_loop.hpp"
#include "app/project.hpp"
#include "app/scene_game.hpp"
#include "core/file.hpp"
#include "input/recorder.hpp"
#include "scene/files/scene_file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

// docs/projects.md says what the engine reads.

namespace plumb {
namespace {

std::string guide() { return *readFile(test::sourceFolder() / "docs/projects.md"); }

/// The first block of code after a heading.
std::string blockAfter(const std::string& heading, const std::string& language) {
    const std::string text = guide();
    const std::string fence = "\n```" + language + "\n";
    const std::size_t begin = text.find(fence, text.find("\n## " + heading + "\n"));
    EXPECT_NE(begin, std::string::npos) << heading;
    return text.substr(begin + fence.size(), text.find("```", begin + fence.size()) - begin - fence.size());
}

TEST(ProjectGuide, showsTheDefaultsOfProjectJson) {
    const Result<Project> shown = projectFromText(blockAfter("project.json", "json"), {}, "shown");
    const Result<Project> none = projectFromText("{}", {}, "none");
    ASSERT_TRUE(shown && none);
    for (const Error& warning : shown->warnings) ADD_FAILURE() << warning.text();
    const auto of = [](const Project& project) {
        return std::tie(project.name, project.version, project.startScene, project.pauseScene,
                        project.windowWidth, project.windowHeight, project.fullscreen, project.width,
                        project.height, project.scaling, project.smooth, project.gravity,
                        project.pixelsPerMetre, project.physicsQuality, project.layers, project.actions);
    };
    EXPECT_TRUE(of(*shown) == of(*none));
}

TEST(ProjectGuide, namesEveryKeyOfProjectJson) {
    // The keys that the code reads, by the object that contains them.
    const std::pair<const char*, const char*> readers[] = {
        {R"(\breader\.(?:text|flag|pair|object)\("(\w+)\")", ""},
        {R"(\bwindow\.\w+\("(\w+)\")", "window."},
        {R"(\bphysics\.\w+\("(\w+)\")", "physics."},
        {R"(\bexported\.\w+\("(\w+)\")", "export."},
        {R"(\bfields\.(?:find|number)\("(\w+)\")", "input."},
    };
    const std::string code = *readFile(test::sourceFolder() / "engine/app/project.cpp") +
                             *readFile(test::sourceFolder() / "engine/input/action_map.cpp");
    const std::string text = guide();
    std::set<std::string> keys;
    for (const auto& [pattern, prefix] : readers) {
        const std::regex expression{pattern};
        for (std::sregex_iterator at{code.begin(), code.end(), expression}, end; at != end; ++at)
            keys.insert(prefix + (*at)[1].str());
    }
    EXPECT_GE(keys.size(), 20u);
    for (const std::string& key : keys) {
        if (key == "window" || key == "physics" || key == "input" || key == "export")
            continue;  // the table has their members
        EXPECT_NE(text.find("`" + key + "`"), std::string::npos) << key;
    }
}

std::string listed(const std::vector<Binding>& bindings) {
    std::string list;
    for (const Binding binding : bindings) list += (list.empty() ? "`" : ", `") + toText(binding) + "`";
    return list;
}

TEST(ProjectGuide, showsTheDefaultKeys) {
    const ActionMap map = ActionMap::defaults();
    std::string actions = "\n| action | keys, mouse buttons and gamepad buttons |\n|---|---|\n";
    for (const ActionBindings& action : map.actions)
        actions += "| `" + action.name + "` | " + listed(action.bindings) + " |\n";
    std::string axes = "\n| axis | negative | positive | stick |\n|---|---|---|---|\n";
    for (const AxisBindings& axis : map.axes)
        axes += "| `" + axis.name + "` | " + listed(axis.negative) + " | " + listed(axis.positive) + " | " +
                listed(axis.analog) + " |\n";
    EXPECT_NE(guide().find(actions + axes + "\n"), std::string::npos) << "copy into it:\n" << actions << axes;
}

TEST(ProjectGuide, itsSceneAndPrefabAreWhatTheEngineWrites) {
    const test::TemporaryFolder folder;
    const std::string scene = blockAfter("Scenes", "json");
    ASSERT_TRUE(writeFile(folder.path / "scenes/shown.scene.json", scene).ok());
    ASSERT_TRUE(writeFile(folder.path / "prefabs/lamp.prefab.json", blockAfter("Prefabs", "json")).ok());
    Project project;
    project.root = folder.path;
    SceneGame game{project};
    game.assets.logging = false;
    const Result<LoadReport> report = switchScene(game.world, game.context(), "scenes/shown.scene.json");
    ASSERT_TRUE(report.ok());
    for (const Error& problem : report->problems) ADD_FAILURE() << problem.text();
    const Result<const Prefab*> prefab = game.context().prefabs->find("prefabs/lamp.prefab.json");
    ASSERT_TRUE(prefab.ok());
    for (const Error& problem : (*prefab)->warnings) ADD_FAILURE() << problem.text();
    EXPECT_EQ(sceneToJson(game.world, game.context(), report->scene), scene);

    const Entity lamp = game.find("lamp");
    ASSERT_TRUE(lamp);
    EXPECT_FALSE(game.world.has<StaticBody>(lamp));
    EXPECT_EQ(lamp.get<const Transform>().position, (Vec2{200.0f, 100.0f}));
    EXPECT_EQ(lamp.get<const Sprite>().width, 8) << "as in the prefab";
    EXPECT_EQ(lamp.get<const Sprite>().tint, (Color{255, 128, 128, 255}));
    EXPECT_EQ(game.find("lamp/light").get<const Sprite>().tint, (Color{128, 255, 128, 255}));
    EXPECT_FALSE(game.find("lamp/moth"));
    EXPECT_TRUE(game.find("hero/hat"));
    EXPECT_EQ(game.find("camera").get<const Camera>().follow, game.find("hero").id());
}

TEST(ProjectGuide, itsReplayPlaysTheGameOfTheRecipes) {
    const std::string text = guide();
    const std::size_t begin = text.find("plumb-replay 1\n");
    const Result<Replay> shown = parseReplay(text.substr(begin, text.find("```", begin) - begin), "shown");
    ASSERT_TRUE(shown.ok()) << shown.error().text();

    Module module;
    plumbDescribeModule(module);
    std::vector<Error> problems;
    const GameContent content{std::move(module), problems};
    Result<Project> project = loadProject(test::sourceFolder() / "tests/code/recipes");
    ASSERT_TRUE(project.ok());
    EXPECT_EQ(shown->project, project->name);
    SceneGame game{std::move(*project), shown->scene, shown->seed, content};
    game.assets.logging = false;
    game.onCreate();
    ReplayPlayer player{*shown};
    while (const InputFrame* frame = player.next()) tickGame(game, *frame);
    EXPECT_EQ(*game.world.resource<LabelValues>().find("score"), "10")
        << "of the coin to the right of the hero";
    EXPECT_GT(game.world.count<Lifetime>(), 1u) << "an enemy and a shot";
}

TEST(ProjectGuide, aHeadlessGamePlays600Ticks) {
    const test::TemporaryFolder folder;
    PlayerOptions options;
    options.headless = true;
    options.record = (folder.path / "run.replay").string();
    Game game;
    EXPECT_EQ((GameLoop{game, nullptr, options, "headless"}.run()), 0);
    const Result<Replay> recorded = loadReplay(options.record);
    ASSERT_TRUE(recorded.ok());
    EXPECT_EQ(recorded->ticks(), 600u);
    EXPECT_NE(guide().find("600 ticks"), std::string::npos);
}

}  // namespace
}  // namespace plumb
