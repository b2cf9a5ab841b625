#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "editor/model/play_mode.hpp"
#include "input/recorder.hpp"
#include "tests/editor/support/played_games.hpp"

namespace plumb::editor {
namespace {

TEST(PlayHash, aReplayPlayedInTheEditorComesOutAsInThePlayer) {
    const Result<Replay> replay = loadReplay(test::sourceFolder() / "tests/replay/platformer.replay");
    ASSERT_TRUE(replay.ok());
    SceneGame game{platformer()};
    game.assets.logging = false;
    game.onCreate();
    PlayMode play;
    play.start(platformerSession("scenes/title.scene.json"));

    ReplayPlayer player{*replay};
    while (const InputFrame* frame = player.next()) {
        tickGame(game, *frame);
        play.step(*frame);
        ASSERT_EQ(play.world().hash(), game.world.hash()) << "tick " << player.tick();
    }
    EXPECT_GT(play.ticks(), 3000);
}

}  // namespace
}  // namespace plumb::editor
