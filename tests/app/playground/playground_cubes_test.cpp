#include <cmath>

#include "tests/app/playground/playground.hpp"

namespace plumb {
namespace {

// Tests the statements of the demonstration scene one by one.

Vec2 velocityOf(Playground& play, std::string_view name) { return play.body(name).velocity; }

/// Drops the small cube from a position.
/// @return height of its first bounce, px
float bounceAt(float x, float y) {
    Playground play{"cubes"};
    teleport(play.game.world.get<Transform>(play.find("small cube")), Vec2{x, y});
    play.runUntil(200, [&] { return velocityOf(play, "small cube").y > 300.0f; });
    play.runUntil(200, [&] { return velocityOf(play, "small cube").y <= 0.0f; });
    const float touched = play.at("small cube").y;
    play.runUntil(200, [&] { return velocityOf(play, "small cube").y >= 0.0f; });
    return touched - play.at("small cube").y;
}

TEST(PlaygroundCubes, theSmallCubeFallsAndTheOthersFloat) {
    Playground play{"cubes"};
    for (const char* other : {"light cube", "heavy cube", "large cube"})
        EXPECT_EQ(play.body(other).gravityScale, 0.0f) << other;
    play.run(20);
    EXPECT_NEAR(velocityOf(play, "small cube").y, 20.0f / 60.0f * 1256.0f, 2.0f);
    const Vec2 light = play.at("light cube");
    play.run(300);
    EXPECT_LT(length(play.at("light cube") - light), 0.5f);
}

TEST(PlaygroundCubes, theFloorBouncesAndTheLargeCubeDoesNot) {
    EXPECT_GT(bounceAt(460, 300), 12.0f);
    EXPECT_LT(bounceAt(1030, 300), 1.0f);
}

TEST(PlaygroundCubes, theFloorHasFrictionAndTheLargeCubeHasNone) {
    const auto speedLeft = [](float x, float y) {
        Playground play{"cubes"};
        teleport(play.game.world.get<Transform>(play.find("small cube")), Vec2{x, y});
        play.run(120);
        play.game.world.get<RigidBody>(play.find("small cube")).velocity = {-100.0f, 0.0f};
        play.run(12);
        return -velocityOf(play, "small cube").x;
    };
    EXPECT_NEAR(speedLeft(460, 610), 0.0f, 1.0f);
    EXPECT_GT(speedLeft(1130, 450), 95.0f);
}

TEST(PlaygroundCubes, theHeavyCubeIsHarderToPushThanTheLightOne) {
    const auto wayOf = [](const char* name, float from) {
        Playground play{"cubes"};
        teleport(play.game.world.get<Transform>(play.find("small cube")), Vec2{from, 615});
        play.run(60);
        const float before = play.at(name).x;
        play.hold(Key::Right, 20);
        return play.at(name).x - before;
    };
    const float light = wayOf("light cube", 600 - 32 - 26), heavy = wayOf("heavy cube", 740 - 48 - 26);
    EXPECT_GT(heavy, 0.5f);
    EXPECT_GT(light, 3.0f * heavy);
}

TEST(PlaygroundCubes, theSpinningTriggerColorsBodiesWithoutStoppingThem) {
    Playground play{"cubes"};
    const auto tint = [&] {
        return std::as_const(play.game.world).get<Sprite>(play.find("small cube")).tint;
    };
    const auto turned = [&] {
        return std::as_const(play.game.world).get<Transform>(play.find("spinning trigger")).rotation;
    };
    const Color own = tint();
    play.run(120);
    EXPECT_GT(std::fabs(turned()), 0.5f);
    EXPECT_EQ(tint(), own);
    play.frame.set(Key::Left, true);
    EXPECT_LT(play.runUntil(200, [&] { return !(tint() == own); }), 200);
    EXPECT_GT(play.at("small cube").x, 240.0f);
    EXPECT_LT(play.runUntil(200, [&] { return tint() == own; }), 200);
    EXPECT_LT(play.at("small cube").x, 240.0f) << "the cube must leave on its entry side";
}

TEST(PlaygroundCubes, aKeyShowsAndHidesTheCountsOfTheThreePhases) {
    Playground play{"cubes"};
    play.run(60);
    const EntityId counters = play.find("counters");
    EXPECT_TRUE(play.game.world.has<Hidden>(counters));
    play.hold(Key::C, 1);
    EXPECT_FALSE(play.game.world.has<Hidden>(counters));
    const std::string_view text =
        play.game.world.texts().find(std::as_const(play.game.world).get<Label>(counters).text);
    for (const char* count : {"{circles}", "{boxes}", "{axes}"})
        EXPECT_NE(text.find(count), std::string_view::npos) << count;
    play.run(1);
    play.hold(Key::C, 1);
    EXPECT_TRUE(play.game.world.has<Hidden>(counters));
}

TEST(PlaygroundCubes, theMouseDragsAndReleasesACube) {
    Playground play{"cubes"};
    play.run(60);
    const Vec2 from = play.at("light cube");
    play.frame.mouseX = static_cast<std::int16_t>(from.x);
    play.frame.mouseY = static_cast<std::int16_t>(from.y);
    play.frame.mouseButtons = 1;
    play.run(2);
    EXPECT_FALSE(play.game.world.has<Hidden>(play.find("hand")));
    play.frame.mouseX = 560;
    play.frame.mouseY = 300;
    play.run(90);
    EXPECT_LT(length(play.at("light cube") - Vec2{560, 300}), 12.0f);
    play.frame.mouseButtons = 0;
    play.run(1);
    EXPECT_FALSE(play.game.world.has<MouseJoint>(play.find("light cube")));
    EXPECT_TRUE(play.game.world.has<Hidden>(play.find("hand")));
}

}  // namespace
}  // namespace plumb
