#include <gtest/gtest.h>

#include "app/game.hpp"
#include "app/game_content.hpp"
#include "app/player.hpp"
#include "app/project.hpp"
#include "app/scene_game.hpp"
#include "core/log.hpp"
#include "scene/components/transform.hpp"
#include "script/script_state.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

constexpr const char* kScene = R"({
  "format": 1,
  "entities": [
    {
      "id": "00000000000000a1",
      "name": "Box",
      "components": {
        "Transform": { "position": [5, 6] },
        "FireBall": { "speed": 90, "label": "hot" }
      }
    }
  ]
})";
constexpr const char* kFireBall = R"(
local FireBall = script { speed = number { 60, unit = "px/s" }, label = "cold" }
function FireBall:onTick(dt)
    self.transform.x = self.transform.x + self.speed * dt
    assert(self.label == "hot")
end
return FireBall
)";

/// A project in a temporary folder with a scene and a script.
class ScriptContent : public testing::Test {
protected:
    ScriptContent() {
        before_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) reported.push_back(line.text);
        });
        write("project.json", R"({"startScene": "scenes/a.scene.json"})");
        write("scenes/a.scene.json", kScene);
        write("scripts/weapons/fire_ball.lua", kFireBall);
    }
    ~ScriptContent() override { setLogSink(before_); }

    void write(const std::string& path, const std::string& text) {
        ASSERT_TRUE(writeFile(folder_.path / path, text).ok());
    }
    [[nodiscard]] Path folder() const { return folder_.path; }
    [[nodiscard]] PlayerOptions options() const {
        PlayerOptions options;
        options.project = folder_.path.string();
        options.headless = true;
        options.frames = 3;
        return options;
    }

    std::vector<std::string> reported;
    std::vector<Error> problems;

private:
    test::TemporaryFolder folder_;
    LogSink before_;
};

TEST_F(ScriptContent, scenesContainComponentsOfScripts) {
    GameContent content{Module{}, problems};
    static_cast<void>(content.readScripts(folder(), problems));
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    const Result<Project> project = loadProject(folder());
    ASSERT_TRUE(project.ok());
    SceneGame game{*project, {}, 1, content};
    game.onCreate();
    for (int i = 0; i < 60; ++i) tickGame(game, {});
    EXPECT_NEAR(game.find("Box").get<Transform>().position.x, 95.0f, 1e-3f);
    EXPECT_TRUE(game.effects.runs(game.world, "pads")) << "scripts may read gamepads";
    EXPECT_TRUE(reported.empty()) << reported[0];
    EXPECT_EQ(game.effects.runsOf(game.world, "scripts"), 120u) << "two systems";
}

TEST_F(ScriptContent, gamesWithoutScriptsHaveNoState) {
    write("scenes/a.scene.json", R"({"format": 1, "entities": []})");
    GameContent content{Module{}, problems};
    static_cast<void>(content.readScripts(folder(), problems));
    const Result<Project> project = loadProject(folder());
    SceneGame game{*project, {}, 1, content};
    game.onCreate();
    for (int i = 0; i < 3; ++i) tickGame(game, {});
    EXPECT_EQ(game.world.findResource<ScriptState>(), nullptr);
    EXPECT_EQ(game.effects.runsOf(game.world, "scripts"), 0u);
}

TEST_F(ScriptContent, aScriptCannotHaveTheNameOfAComponentOfTheEngine) {
    write("scripts/door.lua", "return script {}");
    GameContent content{Module{}, problems};
    static_cast<void>(content.readScripts(folder(), problems));
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].text(),
              "scripts/door.lua: there is a component \"Door\" already; give the file another name");
    EXPECT_EQ(content.types().find("Door")->key, engineContent().types().find("Door")->key);
}

TEST_F(ScriptContent, theErrorOfAUsedNameNamesTheOtherFile) {
    write("scripts/other/fire_ball.lua", "return script {}");
    GameContent content{Module{}, problems};
    static_cast<void>(content.readScripts(folder(), problems));
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].text(),
              "scripts/weapons/fire_ball.lua: there is a component \"FireBall\" already, that of "
              "scripts/other/fire_ball.lua; give the file another name");
}

TEST_F(ScriptContent, errorsOfBlocksDoNotNameTheFunctionAroundTheFile) {
    const std::pair<const char*, const char*> cases[] = {
        {"local A = script {}\nreturn A\n\nfunction A:onTick() end\n",
         "scripts/a.lua:4: 'function' follows a return, which must be the last statement of its block; move "
         "it above the return"},
        {"local A = script {}\nfunction A:onTick()\n    return 1\n    print(2)\nend\nreturn A\n",
         "scripts/a.lua:4: 'print' follows a return, which must be the last statement of its block; move it "
         "above the return"},
        {"local A = script {}\nfunction A:onTick()\n    if true then\nend\nreturn A\n",
         "scripts/a.lua:7: 'end' expected: a function, if or loop above is not closed; close it"},
    };
    for (const auto& [text, expected] : cases) {
        write("scripts/a.lua", text);
        problems.clear();
        GameContent content{Module{}, problems};
        static_cast<void>(content.readScripts(folder(), problems));
        ASSERT_EQ(problems.size(), 1u) << text;
        EXPECT_EQ(problems[0].text(), expected);
    }
}

TEST_F(ScriptContent, anotherVersionConvertsARunningGame) {
    GameContent content{Module{}, problems};
    static_cast<void>(content.readScripts(folder(), problems));
    const Result<Project> project = loadProject(folder());
    SceneGame game{*project, {}, 1, content};
    game.onCreate();
    tickGame(game, {});
    write("scripts/weapons/fire_ball.lua", R"(
        local FireBall = script { heat = integer { 3 }, pace = number { 1, was = "speed" } }
        function FireBall:onTick(dt) self.transform.x = self.transform.x + self.pace * dt + self.heat end
        return FireBall)");
    const ContentChange change = content.readScripts(folder(), problems);
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    ASSERT_EQ(change.types.size(), 1u);
    convertWorld(game.world, content, change);
    game.effects.tableChanged();
    const float x = game.find("Box").get<Transform>().position.x;
    tickGame(game, {});
    EXPECT_NEAR(game.find("Box").get<Transform>().position.x, x + 90.0f / 60.0f + 3.0f, 1e-3f);
    EXPECT_TRUE(reported.empty()) << reported[0];
}

TEST_F(ScriptContent, thePlayerPlaysScriptsAndRefusesBrokenOnes) {
    EXPECT_EQ(playProject(options(), Module{}), 0);
    EXPECT_TRUE(reported.empty()) << reported[0];
    write("scripts/broken.lua", "return script {\n");
    EXPECT_EQ(playProject(options(), Module{}), 1);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_EQ(reported[0].find("scripts/broken.lua:"), 0u) << reported[0];
}

}  // namespace
}  // namespace plumb
