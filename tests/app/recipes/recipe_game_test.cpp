#include <optional>
#include <plumb.hpp>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "app/scene_game.hpp"
#include "tests/support/places.hpp"

// The game of tests/code/recipes, which has all recipes of docs/code.md together, played by keys.

namespace plumb {
namespace {

class RecipeGame : public testing::Test {
protected:
    RecipeGame() {
        previous_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) logged += line.text + "\n";
        });
        Module module;
        plumbDescribeModule(module);
        content_.emplace(std::move(module), problems_);
        for (const Error& problem : problems_) ADD_FAILURE() << problem.text();
        Result<Project> project = loadProject(test::sourceFolder() / "tests/code/recipes");
        EXPECT_TRUE(project && project->warnings.empty());
        game_.emplace(std::move(*project), std::string{}, std::uint64_t{1}, *content_);
        game_->assets.logging = false;
        game_->onCreate();
        wait(1);
    }
    ~RecipeGame() override {
        EXPECT_EQ(logged, "");
        setLogSink(previous_);
    }

    void tick(const InputFrame& frame) { tickGame(*game_, frame); }
    void wait(int ticks) {
        for (int i = 0; i < ticks; ++i) tick({});
    }
    void hold(Key key, int ticks) {
        InputFrame frame;
        frame.set(key, true);
        for (int i = 0; i < ticks; ++i) tick(frame);
    }
    void press(Key key) {
        hold(key, 1);
        wait(1);
    }
    /// The scenes from the bottom to the top, e.g. "level pause".
    std::string scenes() {
        std::string names;
        for (const LoadedScene& scene : game_->world.resource<LoadedScenes>().scenes) {
            const std::size_t from = scene.path.find('/') + 1;
            names += (names.empty() ? "" : " ") + scene.path.substr(from, scene.path.find('.') - from);
        }
        return names;
    }
    /// What labels show for a word.
    std::string shown(const char* word) {
        const std::string* text = game_->world.resource<LabelValues>().find(word);
        return text == nullptr ? "nothing" : *text;
    }
    World& world() { return game_->world; }
    float heroX() { return game_->find("hero").get<const Transform>().position.x; }
    /// Runs into the thorn until the game is over. @return the number of ticks
    int die() {
        int ticks = 0;
        for (; ticks < 600 && scenes() == "level"; ++ticks) hold(Key::Right, 1);
        return ticks;
    }

    std::string logged;  ///< warnings and errors

private:
    LogSink previous_;
    std::vector<Error> problems_;
    std::optional<GameContent> content_;
    std::optional<SceneGame> game_;
};

TEST_F(RecipeGame, allRecipesWorkTogether) {
    EXPECT_EQ(scenes(), "title");
    EXPECT_EQ(shown("best"), "0");
    press(Key::Escape);
    press(Key::P);
    EXPECT_EQ(scenes(), "title") << "the title cannot be paused";

    press(Key::Enter);
    ASSERT_EQ(scenes(), "level");
    EXPECT_EQ(shown("score") + " " + shown("lives"), "0 2");
    const float start = heroX();
    hold(Key::Right, 20);
    EXPECT_EQ(shown("score") + " " + shown("best"), "10 10") << "of the coin on the way";

    press(Key::X);  // shoots
    press(Key::Escape);
    ASSERT_EQ(scenes(), "level pause");
    const float paused = heroX();
    hold(Key::Right, 30);
    EXPECT_EQ(heroX(), paused);
    press(Key::Escape);
    ASSERT_EQ(scenes(), "level");
    hold(Key::Right, 2);
    EXPECT_GT(heroX(), paused);
    for (const Key key : {Key::P, Key::Enter}) press(key);  // Enter: the item "Continue"
    ASSERT_EQ(scenes(), "level");

    die();
    ASSERT_EQ(scenes(), "level game_over");
    EXPECT_EQ(shown("lives"), "0");
    for (const Key key : {Key::Escape, Key::P, Key::Backspace, Key::R, Key::Escape}) press(key);
    EXPECT_EQ(scenes(), "level game_over") << "the dead hero stays dead";

    press(Key::Enter);
    ASSERT_EQ(scenes(), "level");
    EXPECT_EQ(shown("score") + " " + shown("best") + " " + shown("lives"), "0 10 2");
    EXPECT_EQ(heroX(), start);
    press(Key::R);
    EXPECT_EQ(scenes(), "level");
    for (const Key key : {Key::Escape, Key::Down, Key::Down, Key::Enter}) press(key);
    EXPECT_EQ(scenes(), "title");
    EXPECT_EQ(shown("best"), "10");
}

TEST_F(RecipeGame, theEndOfTheGameIsNotLostIfPauseIsPressedInTheSameTick) {
    press(Key::Enter);
    const int ticks = die();
    ASSERT_LT(ticks, 600);
    press(Key::Enter);
    ASSERT_EQ(scenes(), "level");
    hold(Key::Right, ticks - 1);
    ASSERT_EQ(scenes(), "level");
    InputFrame frame;
    frame.set(Key::Right, true);
    frame.set(Key::Escape, true);
    tick(frame);
    EXPECT_EQ(scenes(), "level game_over");
}

TEST_F(RecipeGame, ofSeveralChangesOfTheSceneInOneTickTheLastCounts) {
    press(Key::Enter);
    press(Key::Escape);
    ASSERT_EQ(scenes(), "level pause");
    showOverlay(world(), "game_over");
    restartScene(world());
    hideOverlay(world());
    tick({});
    EXPECT_EQ(scenes(), "level game_over") << "the overlay is closed first, and nothing is loaded again";
    changeScene(world(), "level");
    changeScene(world(), "title");
    restartScene(world());
    tick({});
    EXPECT_EQ(scenes(), "title");
}

}  // namespace
}  // namespace plumb
