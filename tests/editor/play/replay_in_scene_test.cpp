#include "editor/model/play/replay_in_scene.hpp"

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "editor/model/project/project_session.hpp"
#include "input/recorder.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

/// The first 700 ticks of the platformer's replay: from the title into the first level.
class ReplayInScene : public testing::Test {
protected:
    ReplayInScene() : before_{setLogSink([](const LogLine&) {})} {}
    ~ReplayInScene() override { setLogSink(before_); }
    void SetUp() override {
        Result<Replay> whole = loadReplay(test::sourceFolder() / "tests/replay/platformer.replay");
        ASSERT_TRUE(whole.ok());
        replay = *whole;
        replay.runs.clear();
        std::uint64_t left = kTicks;
        for (InputRun run : whole->runs) {
            run.ticks = std::min(run.ticks, left);
            if (run.ticks > 0) replay.runs.push_back(run);
            left -= run.ticks;
        }
        std::erase_if(replay.checkpoints, [](const HashCheck& check) { return check.tick > kTicks; });
        ASSERT_FALSE(replay.checkpoints.empty());
        Result<std::unique_ptr<ProjectSession>> opened =
            ProjectSession::open((test::sourceFolder() / "projects/platformer").string());
        ASSERT_TRUE(opened.ok());
        session_ = std::move(*opened);
        session_->openFirst(replay.scene);
    }
    Workspace& workspace() { return session_->workspace(); }
    PlayMode& game() { return workspace().play; }

    static constexpr std::uint64_t kTicks = 700;
    Replay replay;

private:
    LogSink before_;
    std::unique_ptr<ProjectSession> session_;
};

TEST_F(ReplayInScene, pauses2SecondsBeforeTheEndAndPlaysTheRest) {
    ASSERT_TRUE(playReplayInScene(workspace(), replay, "a.replay").ok());
    EXPECT_TRUE(game().paused());
    EXPECT_EQ(game().ticks(), 580);
    EXPECT_EQ(game().newest(), 700);
    const std::uint64_t shown = game().world().hash();
    game().seek(700);
    const std::uint64_t last = game().world().hash();
    game().seek(580);
    EXPECT_EQ(game().world().hash(), shown);
    game().playReplay();
    while (!game().paused()) game().step({});
    EXPECT_EQ(game().ticks(), 700);
    EXPECT_EQ(game().world().hash(), last);
}

TEST_F(ReplayInScene, leavesOutTheTickOfTheCrash) {
    replay.crash = {"SIGSEGV, a wrong access to memory", "MoveSystem", ""};
    ASSERT_TRUE(playReplayInScene(workspace(), replay, "a.replay").ok());
    EXPECT_EQ(game().newest(), 699);
    EXPECT_EQ(game().ticks(), 579);
    EXPECT_NE(workspace().notice.find("Tick 579 of 700"), std::string::npos) << workspace().notice;
    EXPECT_NE(workspace().notice.find("SIGSEGV, a wrong access to memory, running MoveSystem"),
              std::string::npos)
        << workspace().notice;
}

TEST_F(ReplayInScene, usesTheRecordedSeed) {
    ASSERT_TRUE(playReplayInScene(workspace(), replay, "a.replay").ok());
    const std::uint64_t known = game().world().hash();
    workspace().stopPlaying();
    replay.seed = 77;
    replay.checkpoints.clear();
    ASSERT_TRUE(playReplayInScene(workspace(), replay, "a.replay").ok());
    EXPECT_NE(game().world().hash(), known);
}

TEST_F(ReplayInScene, refusesOneOfAnotherProjectOrOfAnotherVersion) {
    replay.checkpoints.front().hash ^= 1;
    const Result<Done> changed = playReplayInScene(workspace(), replay, "a.replay");
    ASSERT_FALSE(changed.ok());
    EXPECT_NE(changed.error().what.find("differs from the recorded one at tick"), std::string::npos);
    replay.project = "Other";
    const Result<Done> other = playReplayInScene(workspace(), replay, "a.replay");
    ASSERT_FALSE(other.ok());
    EXPECT_EQ(other.error().what, "it was recorded by the project \"Other\", and this is \"Wickwood\"");
}

TEST_F(ReplayInScene, shorterThan2SecondsPausesBeforeItsFirstTick) {
    replay.checkpoints.clear();
    replay.runs = {{InputFrame{}, 5}};
    ASSERT_TRUE(playReplayInScene(workspace(), replay, "a.replay").ok());
    EXPECT_EQ(game().ticks(), 0);
    EXPECT_EQ(game().newest(), 5);
}

}  // namespace
}  // namespace plumb::editor
