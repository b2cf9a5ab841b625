#include <string>

#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "scene/components/transform.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

/// Returns the first block of a language after a text of the README.
std::string blockAfter(const std::string& readme, std::string_view text, std::string_view language) {
    const std::string fence = "```" + std::string{language} + "\n";
    const std::size_t begin = readme.find(fence, readme.find(text)) + fence.size();
    return readme.substr(begin, readme.find("```", begin) - begin);
}

/// The game of the README's five-minute introduction, made by its steps.
class ReadmeGame : public testing::TestWithParam<Key> {
protected:
    ReadmeGame() {
        previous_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) warnings += line.text + "\n";
        });
        const std::string readme = *readFile(test::sourceFolder() / "README.md");
        write("project.json", blockAfter(readme, "## A game in five minutes", "json"));
        write("scenes/start.scene.json", blockAfter(readme, "2. Put", "json"));
        write("scripts/come_back.lua", blockAfter(readme, "3. `ComeBack`", "lua"));
    }
    ~ReadmeGame() override { setLogSink(previous_); }

    [[nodiscard]] const Path& folder() const { return home_.path; }

    std::string warnings;

private:
    void write(const char* path, const std::string& text) {
        EXPECT_TRUE(writeFile(home_.path / path, text).ok());
    }

    test::TemporaryFolder home_;
    LogSink previous_;
};

Vec2 heroOf(World& world) {
    int heroes = 0;
    Vec2 position;
    for (auto [entity, hero, transform] : world.query<const PlayerController, const Transform>()) {
        position = transform.position;
        ++heroes;
    }
    EXPECT_EQ(heroes, 1);
    return position;
}

TEST_P(ReadmeGame, itsPlayerComesBackWhenItFalls) {
    const Result<Project> project = loadProject(folder());
    ASSERT_TRUE(project.ok());
    EXPECT_TRUE(project->warnings.empty());
    std::vector<Error> problems;
    GameContent content{{}, problems};
    static_cast<void>(content.readScripts(folder(), problems));
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    SceneGame game{*project, "", 1, content};
    game.onCreate();
    ASSERT_FALSE(game.failure());

    const Vec2 home = heroOf(game.world);
    Vec2 before = home;
    int falls = 0;
    for (int tick = 0; tick < 600; ++tick) {
        InputFrame frame;
        frame.set(GetParam(), true);
        tickGame(game, frame);
        const Vec2 now = heroOf(game.world);
        if (before.y >= 200.0f) {  // the height below which the script moves it back
            ++falls;
            EXPECT_NEAR(now.x, home.x, 4.0f) << "tick " << tick;
            EXPECT_NEAR(now.y, home.y, 1.0f) << "without the speed of its fall, tick " << tick;
        }
        before = now;
    }
    EXPECT_GE(falls, 3);
    EXPECT_EQ(warnings, "");
}

INSTANTIATE_TEST_SUITE_P(BothWays, ReadmeGame, testing::Values(Key::Left, Key::Right));

}  // namespace
}  // namespace plumb
