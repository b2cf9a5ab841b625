#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "gameplay/game_progress.hpp"
#include "input/recorder.hpp"
#include "tests/app/projects/platformer.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

// Hash of the world after the replay. A commit that changes it must name the change of levels or simulation.
// tests/replay/solve_platformer.cpp creates a new replay.
constexpr std::uint64_t kHashAtTheEnd = 0x69324480c90a307bull;

TEST(PlatformerReplay, playsFromTheTitleThroughAllLevelsToTheEndScreenBitForBit) {
    Result<Replay> replay = loadReplay(test::sourceFolder() / "tests/replay/platformer.replay");
    ASSERT_TRUE(replay.ok());
    SceneGame game{platformer()};
    game.assets.logging = false;
    game.onCreate();
    ReplayPlayer player{*replay};

    int checks = 0;
    while (const InputFrame* frame = player.next()) {
        tickGame(game, *frame);
        if (const auto* check = player.checkpoint()) {
            ASSERT_EQ(game.world.hash(), check->hash) << "tick " << check->tick;
            ++checks;
        }
    }

    const GameProgress& progress = game.world.resource<GameProgress>();
    EXPECT_EQ(progress.levelsReached.size(), 4u);
    EXPECT_TRUE(progress.gameFinished);
    EXPECT_EQ(progress.coins, 56);
    EXPECT_EQ(progress.coinsTotal, 88);
    EXPECT_EQ(progress.deaths, 0);
    EXPECT_GE(checks, 10);
    EXPECT_EQ(game.world.hash(), kHashAtTheEnd);
}

}  // namespace
}  // namespace plumb
