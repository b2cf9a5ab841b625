#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "core/file.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "tests/app/projects/platformer.hpp"

namespace plumb {
namespace {

/// Returns the first JSON block after a text of the README.
std::string blockAfter(const std::string& readme, std::string_view text) {
    const std::size_t begin = readme.find("```json\n", readme.find(text)) + 8;
    return readme.substr(begin, readme.find("```", begin) - begin);
}

/// The game of the README's five-minute introduction.
class ReadmeGame : public testing::TestWithParam<Key> {
protected:
    ReadmeGame() {
        const std::string readme = *readFile(test::sourceFolder() / "README.md");
        std::filesystem::create_directories(folder_ / "scenes");
        EXPECT_TRUE(
            writeFile(folder_ / "project.json", blockAfter(readme, "## A game in five minutes")).ok());
        EXPECT_TRUE(writeFile(folder_ / "scenes/start.scene.json", blockAfter(readme, "2. Put")).ok());
    }
    ~ReadmeGame() override { std::filesystem::remove_all(folder_); }

    Path folder_ = std::filesystem::temp_directory_path() / "plumb_readme_game" /
                   std::to_string(static_cast<int>(GetParam()));
};

TEST_P(ReadmeGame, itsPlayerStaysOnTheScreen) {
    const Result<Project> project = loadProject(folder_);
    ASSERT_TRUE(project.ok());
    EXPECT_TRUE(project->warnings.empty());
    SceneGame game{*project, ""};
    game.onCreate();
    ASSERT_FALSE(game.failed());
    for (int tick = 0; tick < 600; ++tick) {
        InputFrame frame;
        frame.set(GetParam(), true);
        frame.set(Key::Space, tick % 60 < 20);
        tickGame(game, frame);
    }
    int heroes = 0;
    for (auto [entity, hero, transform] : game.world.query<const PlayerController, const Transform>()) {
        ++heroes;
        EXPECT_NEAR(transform.position.x, GetParam() == Key::Left ? 0.0f : 320.0f - 12.0f, 0.1f);
        EXPECT_NEAR(transform.position.y, 140.0f - 16.0f, 60.0f);
    }
    EXPECT_EQ(heroes, 1);
}

INSTANTIATE_TEST_SUITE_P(BothWays, ReadmeGame, testing::Values(Key::Left, Key::Right));

}  // namespace
}  // namespace plumb
