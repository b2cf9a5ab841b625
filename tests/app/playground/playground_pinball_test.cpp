#include <algorithm>
#include <cstdint>

#include "core/random.hpp"
#include "tests/app/playground/pinball_hands.hpp"
#include "tests/app/playground/playground.hpp"
#include "tests/app/projects/project_replays.hpp"

// The scene "pinball", whose rules are Lua scripts.

namespace plumb {
namespace {

std::int64_t points(Playground& play) { return play.property<std::int64_t>("rules", "Score", "points"); }

TEST(PlaygroundPinball, theReplayScoresForHalfAMinute) {
    const Replay replay = replayOf(kPinballReplay);
    EXPECT_GE(replay.ticks(), 1800u);
    Playground play{kPinballReplay.scene};
    for (const InputFrame& frame : framesOf(replay)) {
        play.frame = frame;
        play.run(1);
    }
    EXPECT_GT(points(play), 0);
    EXPECT_EQ(play.shown("score"), std::to_string(points(play)));
    EXPECT_EQ(play.property<std::int64_t>("rules", "Score", "best"), points(play));
}

TEST(PlaygroundPinball, theBallWaitsOnThePlungerAndIsLaunchedByIt) {
    Playground play{"pinball"};
    play.run(120);
    const Vec2 start = play.at("ball");
    play.run(300);
    EXPECT_LT(length(play.at("ball") - start), 1.0f);
    play.hold(Key::Space, 60);
    EXPECT_GT(play.at("ball").y, start.y + 40.0f) << "it goes down with the plunger";
    EXPECT_LT(play.runUntil(120, [&] { return play.at("ball").y < 100.0f; }), 120);
    EXPECT_LT(play.runUntil(120, [&] { return play.at("ball").x < 700.0f; }), 120);
    EXPECT_NEAR(play.at("plunger").y, 650.0f, 0.1f);
}

TEST(PlaygroundPinball, aFlipperTurnsUpWhileItsKeyIsHeld) {
    Playground play{"pinball"};
    const auto angleOf = [&](const char* name) {
        return std::as_const(play.game.world).get<Transform>(play.find(name)).rotation;
    };
    play.run(5);
    const float left = angleOf("left flipper");
    const float right = angleOf("right flipper");
    play.hold(Key::Left, 6);
    EXPECT_NEAR(angleOf("left flipper"), left - 0.94f, 1e-3f);
    EXPECT_NEAR(angleOf("right flipper"), right, 1e-3f);
    play.hold(Key::Right, 6);
    EXPECT_NEAR(angleOf("left flipper"), left, 1e-3f);
    EXPECT_NEAR(angleOf("right flipper"), right + 0.94f, 1e-3f);
}

/// Random keys: the ball stays in the table and is never still for five seconds, except on the plunger.
void expectTheBallInMotion(Playground& play, Random random) {
    constexpr int kMinute = 3600;  // ticks
    constexpr int kMostStill = 300;
    Vec2 before = play.at("ball");
    int still = 0;
    for (int tick = 0; tick < kMinute; ++tick) {
        for (const Key key : {Key::Left, Key::Right, Key::Space}) {
            const std::uint32_t pause = key == Key::Space ? 40 : 15;  // ticks between changes, on average
            if (random.below(pause) == 0) play.frame.set(key, !play.frame.has(key));
        }
        play.run(1);
        const Vec2 ball = play.at("ball");
        ASSERT_GT(ball.x, 420.0f) << tick;
        ASSERT_LT(ball.x, 862.0f) << tick;
        ASSERT_GT(ball.y, 30.0f) << tick;
        ASSERT_LT(ball.y, 780.0f) << tick;
        const bool moves = isInLane(ball) || length(ball - before) > 3.0f;
        still = moves ? 0 : still + 1;
        if (moves) before = ball;
        ASSERT_LT(still, kMostStill) << tick << ": " << ball.x << " " << ball.y;
    }
}

TEST(PlaygroundPinball, theBallStaysInTheTableAndInMotion) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        Playground play{"pinball"};
        ASSERT_NO_FATAL_FAILURE(expectTheBallInMotion(play, Random::seeded(seed)));
    }
}

/// Puts the ball above the drain, and waits until it comes back or the game is over.
void loseBall(Playground& play) {
    const EntityId ball = play.find("ball");
    teleport(play.game.world.get<Transform>(ball), {620.0f, 690.0f});
    play.game.world.get<RigidBody>(ball).velocity = {};
    play.run(30);
    EXPECT_GT(play.at(ball).y, 700.0f);
    play.run(90);
}

TEST(PlaygroundPinball, aGameHasThreeBallsAndSpaceStartsTheNext) {
    Playground play{"pinball"};
    play.run(10);
    EXPECT_EQ(play.shown("ball"), "1 of 3");
    loseBall(play);
    EXPECT_TRUE(isInLane(play.at("ball")));
    EXPECT_EQ(play.shown("ball"), "1 of 3") << "a ball without points comes back once more";
    for (const char* next : {"2 of 3", "3 of 3"}) {
        play.property<std::int64_t>("rules", "Score", "points") += 1000;
        loseBall(play);
        EXPECT_EQ(play.shown("ball"), next);
        EXPECT_TRUE(isInLane(play.at("ball")));
        EXPECT_EQ(play.shown("message"), "");
    }
    play.property<std::int64_t>("rules", "Score", "points") += 1000;
    loseBall(play);
    EXPECT_EQ(play.shown("message").substr(0, 9), "Game over");
    EXPECT_FALSE(isInLane(play.at("ball")));
    play.hold(Key::Space, 2);
    EXPECT_EQ(play.shown("ball"), "1 of 3");
    EXPECT_EQ(play.shown("score"), "0");
    EXPECT_TRUE(isInLane(play.at("ball")));
}

TEST(PlaygroundPinball, targetsFallGiveABonusTogetherAndComeBack) {
    constexpr int kAway = 12 * 60;  // ticks
    Playground play{"pinball"};
    play.run(10);
    const EntityId ball = play.find("ball");
    const auto isDown = [&](EntityId target) {
        return std::as_const(play.game.world).get<BoxCollider>(target).isTrigger;
    };
    const std::vector<EntityId> targets = play.all("left target ");
    ASSERT_EQ(targets.size(), 3u);
    for (const EntityId target : targets) {
        EXPECT_FALSE(isDown(target));
        teleport(play.game.world.get<Transform>(ball), play.at(target) + Vec2{40.0f, 0.0f});
        play.game.world.get<RigidBody>(ball).velocity = {-600.0f, 0.0f};
        play.run(6);
        EXPECT_TRUE(isDown(target));
    }
    EXPECT_EQ(points(play), 250 + 250 + 2500);
    teleport(play.game.world.get<Transform>(ball), {846.0f, 600.0f});
    play.game.world.get<RigidBody>(ball).velocity = {};
    play.run(kAway + 10);
    for (const EntityId target : targets) EXPECT_FALSE(isDown(target));
}

TEST(PlaygroundPinball, threeLanesRaiseTheMultiplier) {
    Playground play{"pinball"};
    play.run(10);
    const EntityId ball = play.find("ball");
    for (const EntityId lane : play.all("lane ")) {
        EXPECT_EQ(play.shown("times"), "1");
        teleport(play.game.world.get<Transform>(ball), play.at(lane));
        play.game.world.get<RigidBody>(ball).velocity = {};
        play.run(2);
    }
    EXPECT_EQ(points(play), 150);
    EXPECT_EQ(play.shown("times"), "2");
    loseBall(play);
    EXPECT_EQ(play.shown("times"), "1") << "it counts for one ball";
}

}  // namespace
}  // namespace plumb
