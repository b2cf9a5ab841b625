#include "app/reload/edited_files.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "app/project.hpp"
#include "app/scene_game.hpp"
#include "core/log.hpp"
#include "gameplay/game_functions.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/transform.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

std::string prefab(int width) {
    return R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "Coin",
        "components": {"Transform": {}, "Sprite": {"width": )" +
           std::to_string(width) + "}}}]}";
}

std::string scene(const std::string& components) {
    return R"({"format": 1, "entities": [
        {"id": "00000000000000a1", "name": "Box", "components": {"Transform": {}, )" +
           components + R"(}},
        {"id": "00000000000000a2", "name": "Held", "prefab": "prefabs/coin.prefab.json"}]})";
}

/// Moves its entity to the number of ticks since its first, plus a number in the text of the file.
std::string mover(int offset) {
    return "local Mover = script { speed = number { 1 } }\n"
           "function Mover:onTick(dt) self.ticks = (self.ticks or 0) + 1\n"
           "    self.transform.x = self.ticks + " +
           std::to_string(offset) +
           " end\n"
           "function Mover:onReload() self.transform.y = self.transform.y + 1 end\n"
           "return Mover\n";
}

/// A running game whose files are edited.
class EditedFilesTest : public testing::Test {
protected:
    EditedFilesTest() {
        write("project.json", R"({"startScene": "scenes/a.scene.json"})");
        write("scenes/a.scene.json", scene(R"("Mover": {})"));
        write("prefabs/coin.prefab.json", prefab(4));
        write("scripts/mover.lua", mover(0));
        static_cast<void>(content_.readScripts(folder_.path, problems_));
        before_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) reported.push_back(line.text);
        });
        game.emplace(*loadProject(folder_.path), std::string{}, std::uint64_t{1}, content_);
        game->onCreate();
        watch();
    }
    ~EditedFilesTest() override { setLogSink(before_); }

    void write(const std::string& path, const std::string& text) {
        ASSERT_TRUE(writeFile(folder_.path / path, text).ok());
    }
    /// As the loop of a game that begins.
    void watch() { edited_.emplace(*game, &content_); }
    /// Another frame, some time later. @return true if files had changed
    bool frame() {
        const bool changed = edited_->look(now_ += 1.0);
        if (changed) edited_->take();
        tickGame(*game, {});
        return changed;
    }
    [[nodiscard]] Vec2 place() { return game->find("Box").get<Transform>().position; }
    [[nodiscard]] int widthOf(Entity coin) { return coin ? coin.get<Sprite>().width : 0; }

    std::vector<std::string> reported;
    std::optional<SceneGame> game;

private:
    test::TemporaryFolder folder_;
    std::vector<Error> problems_;
    GameContent content_{Module{}, problems_};
    std::optional<EditedFiles> edited_;
    LogSink before_;
    double now_ = 0.0;
};

TEST_F(EditedFilesTest, aChangedScriptGoesOnWithItsValues) {
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(frame());
    EXPECT_EQ(place(), (Vec2{3.0f, 0.0f}));
    write("scripts/mover.lua", mover(100));
    EXPECT_TRUE(frame());
    EXPECT_EQ(place(), (Vec2{104.0f, 1.0f})) << "self.ticks is kept, onReload was called";
    EXPECT_FALSE(frame());
    EXPECT_EQ(place(), (Vec2{105.0f, 1.0f}));
    EXPECT_TRUE(reported.empty()) << reported[0];
}

TEST_F(EditedFilesTest, aScriptThatIsSavedWhileTheGameStartsIsNoticed) {
    write("scripts/mover.lua", mover(100));  // after it was read
    watch();
    EXPECT_TRUE(frame());
    EXPECT_EQ(place().x, 101.0f);
    EXPECT_FALSE(frame());
}

TEST_F(EditedFilesTest, ofAScriptWithAnErrorTheFormerVersionGoesOn) {
    frame();
    write("scripts/mover.lua", "local Mover = script {}\nfunction Mover:onTick(\nreturn Mover\n");
    EXPECT_TRUE(frame());
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_EQ(reported[0].find("scripts/mover.lua:3: "), 0u) << reported[0];
    EXPECT_FALSE(frame()) << "it is reported once";
    EXPECT_EQ(place(), (Vec2{3.0f, 0.0f}));
    write("scripts/mover.lua", mover(10));
    EXPECT_TRUE(frame());
    EXPECT_EQ(place(), (Vec2{14.0f, 1.0f}));
    EXPECT_EQ(reported.size(), 1u);
}

TEST_F(EditedFilesTest, aSceneKnowsANewScriptThatWasSavedAfterIt) {
    frame();
    write("scenes/a.scene.json", scene(R"("Lifter": {})"));
    write("scripts/lifter.lua",
          "local Lifter = script {}\nfunction Lifter:onTick() self.transform.y = 50 end\nreturn Lifter\n");
    EXPECT_TRUE(frame());
    EXPECT_EQ(place(), (Vec2{0.0f, 50.0f}));
    EXPECT_TRUE(reported.empty()) << reported[0];
}

TEST_F(EditedFilesTest, aChangedPrefabIsSpawnedAndInASceneThatIsLoadedAgain) {
    frame();
    ASSERT_EQ(widthOf(game->spawn("coin", {})), 4);
    write("prefabs/coin.prefab.json", prefab(16));
    EXPECT_TRUE(frame());
    EXPECT_EQ(widthOf(game->spawn("coin", {})), 16);
    EXPECT_EQ(widthOf(game->find("Held")), 4) << "what is in the scene stays";
    restartScene(game->world);
    frame();
    EXPECT_EQ(widthOf(game->find("Held")), 16);
    EXPECT_TRUE(reported.empty()) << reported[0];
}

TEST_F(EditedFilesTest, ofAPrefabThatCannotBeReadTheFormerVersionGoesOn) {
    frame();
    write("prefabs/coin.prefab.json", R"({"format": 1, "entities": [)");
    EXPECT_TRUE(frame());
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_EQ(reported[0].find("prefabs/coin.prefab.json:1"), 0u) << reported[0];
    EXPECT_EQ(widthOf(game->spawn("coin", {})), 4);
    restartScene(game->world);
    frame();
    EXPECT_EQ(widthOf(game->find("Held")), 4);
    write("prefabs/coin.prefab.json", prefab(20));
    EXPECT_TRUE(frame());
    EXPECT_EQ(widthOf(game->spawn("coin", {})), 20);
    EXPECT_EQ(reported.size(), 1u);
}

}  // namespace
}  // namespace plumb
