#include "app/scene_game.hpp"

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "scene/scene_requests.hpp"

namespace plumb {
namespace {

Project platformer() {
    Result<Project> project = loadProject(Path{PLUMB_SOURCE_DIR} / "projects/platformer");
    EXPECT_TRUE(project.ok());
    return *project;
}

std::uint64_t hashAfter(const std::string& scene, int ticks) {
    SceneGame game{platformer(), scene};
    game.assets.logging = false;
    game.onCreate();
    EXPECT_FALSE(game.failed());
    for (int i = 0; i < ticks; ++i) {
        InputFrame frame;
        frame.set(Key::Right, i % 90 < 70);
        frame.set(Key::Space, i % 45 < 12);
        tickGame(game, frame);
    }
    return game.world.hash();
}

TEST(SceneGame, theSameInputGivesTheSameBits) {
    for (const char* scene : {"level1", "level2", "level3", "level4"}) {
        SCOPED_TRACE(scene);
        const std::uint64_t first = hashAfter(scene, 300);
        EXPECT_EQ(hashAfter(scene, 300), first);
        EXPECT_NE(hashAfter(scene, 301), first) << "nothing happens in this scene";
    }
}

TEST(SceneGame, aRestoredSnapshotReplaysToTheSameState) {
    SceneGame game{platformer(), "level2"};
    game.assets.logging = false;
    game.onCreate();
    Snapshot snapshot;
    for (int i = 0; i < 200; ++i) {
        InputFrame frame;
        frame.set(Key::Right, true);
        frame.set(Key::Space, i % 40 < 10);
        game.world.save(snapshot);
        tickGame(game, frame);
        const std::uint64_t first = game.world.hash();
        game.world.restore(snapshot);
        tickGame(game, frame);
        ASSERT_EQ(game.world.hash(), first) << "tick " << i;
    }
}

TEST(SceneGame, aHundredSceneSwitchesLeaveNothingBehind) {
    SceneGame game{platformer(), "level1"};
    game.assets.logging = false;
    game.onCreate();
    const std::size_t entities = game.world.entityCount();
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(
            game.openScene(i % 2 == 0 ? "scenes/level2.scene.json" : "scenes/level1.scene.json").ok());
        tickGame(game, InputFrame{});
    }
    EXPECT_EQ(game.world.entityCount(), entities);
}

TEST(SceneGame, aSceneThatIsNotThereIsAnErrorAndTheOldOneGoesOn) {
    SceneGame game{platformer(), "level1"};
    game.assets.logging = false;
    game.onCreate();
    const std::size_t entities = game.world.entityCount();

    const auto opened = game.openScene("scenes/nowhere.scene.json");

    ASSERT_FALSE(opened.ok());
    EXPECT_FALSE(opened.error().remedy.empty());
    EXPECT_EQ(game.world.entityCount(), entities);
}

TEST(SceneGameProperty, openingAndSavingEverySceneOfEveryProjectChangesNoByte) {
    int scenes = 0;
    for (const std::string& path : filesBelow(Path{PLUMB_SOURCE_DIR} / "projects", ".scene.json")) {
        SCOPED_TRACE(path);
        const std::size_t cut = path.find('/');
        Result<Project> project = loadProject(Path{PLUMB_SOURCE_DIR} / "projects" / path.substr(0, cut));
        ASSERT_TRUE(project.ok());
        SceneGame game{*project};
        game.assets.logging = false;
        const std::string name = path.substr(cut + 1);
        ASSERT_TRUE(game.openScene(name).ok());
        EXPECT_EQ(sceneToJson(game.world, game.context(), sceneId(name)),
                  *readFile(Path{PLUMB_SOURCE_DIR} / "projects" / path));
        ++scenes;
    }
    EXPECT_GE(scenes, 6);
}

}  // namespace
}  // namespace plumb
