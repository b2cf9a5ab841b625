#include <utility>

#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "editor/model/play_mode.hpp"
#include "input/recorder.hpp"
#include "tests/editor/support/played_games.hpp"

namespace plumb::editor {
namespace {

/// One of many types that no entity has: panels and overlays ask for types that no player asks for.
template <int N>
struct Looked {
    int value = N;
};

template <int... N>
void look(const World& world, std::integer_sequence<int, N...>) {
    (static_cast<void>(world.query<const Looked<N>>().count()), ...);
}

TEST(PlayHash, aReplayPlayedInTheEditorComesOutAsInThePlayer) {
    const Result<Replay> replay = loadReplay(test::sourceFolder() / "tests/replay/platformer.replay");
    ASSERT_TRUE(replay.ok());
    SceneGame game{platformer()};
    game.assets.logging = false;
    game.onCreate();
    PlayMode play;
    play.start(platformerSession("scenes/title.scene.json"));
    look(play.world(), std::make_integer_sequence<int, 100>{});

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
