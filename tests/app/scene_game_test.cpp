#include "app/scene_game.hpp"

#include <gtest/gtest.h>

#include "tests/app/platformer.hpp"

namespace plumb {
namespace {

std::uint64_t hashAfter(const std::string& scene, int ticks) {
    SceneGame game{platformer(), scene};
    game.assets.logging = false;
    game.onCreate();
    EXPECT_FALSE(game.failed());
    std::size_t moved = 0;
    for (int i = 0; i < ticks; ++i) {
        InputFrame frame;
        frame.set(Key::Right, i % 90 < 70);
        frame.set(Key::Space, i % 45 < 12);
        tickGame(game, frame);
        moved += movedEntities(game.world);
    }
    EXPECT_GT(moved, 0u) << "nothing happens in this scene";
    return game.world.hash();
}

TEST(SceneGame, theSameInputGivesTheSameBits) {
    for (const char* scene : {"level1", "level2", "level3", "level4"}) {
        SCOPED_TRACE(scene);
        const std::uint64_t first = hashAfter(scene, 300);
        EXPECT_EQ(hashAfter(scene, 300), first);
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

}  // namespace
}  // namespace plumb
