#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "core/file.hpp"
#include "editor/model/play/game_session.hpp"
#include "editor/model/play/play_mode.hpp"
#include "scene/files/scene_path.hpp"
#include "tests/app/projects/project_replays.hpp"

namespace plumb::editor {
namespace {

/// One of many component types that no entity has. Panels and overlays query types that the player program
/// never queries; this must not change the hash.
template <int N>
struct Looked {
    int value = N;
};

template <int... N>
void look(const World& world, std::integer_sequence<int, N...>) {
    (static_cast<void>(world.query<const Looked<N>>().count()), ...);
}

class PlayHash : public testing::TestWithParam<ProjectReplay> {};

std::unique_ptr<PlaySession> sessionOf(const Project& project, std::string_view scene,
                                       const GameContent& content) {
    const std::string path = scene.empty() ? project.startScene : scenePath(scene);
    const Result<std::string> text = readFile(project.root / path);
    EXPECT_TRUE(text.ok());
    return makeGameSession(project, path, *text, content);
}

/// Pauses the game, seeks back and returns to the newest tick.
void pauseAndLookBack(PlayMode& play) {
    const std::int64_t now = play.ticks();
    play.setPaused(true);
    play.seek(std::max(play.oldest(), now - 25));
    EXPECT_LT(play.ticks(), now);
    play.seek(now);
    play.setPaused(false);
    EXPECT_EQ(play.ticks(), now);
}

TEST_P(PlayHash, aReplayHasTheSameHashesInTheEditorAndInThePlayer) {
    constexpr std::int64_t kPauseEvery = 400;  // ticks
    const Replay replay = replayOf(GetParam());
    const Project project = projectOf(GetParam());
    ProjectGame player{project, GetParam().scene};
    SceneGame& game = player.game;
    game.onCreate();
    PlayMode play;
    play.start(sessionOf(project, GetParam().scene, *player.content));
    look(play.world(), std::make_integer_sequence<int, 100>{});

    for (const InputFrame& frame : framesOf(replay)) {
        tickGame(game, frame);
        play.step(frame);
        ASSERT_EQ(play.world().hash(), game.world.hash()) << "tick " << play.ticks();
        if (play.ticks() % kPauseEvery == 0) pauseAndLookBack(play);
    }
    EXPECT_EQ(play.ticks(), static_cast<std::int64_t>(replay.ticks()));
    EXPECT_GT(play.ticks(), kPauseEvery);
}

INSTANTIATE_TEST_SUITE_P(Each, PlayHash, testing::ValuesIn(kProjectReplays), testNameOf);

}  // namespace
}  // namespace plumb::editor
