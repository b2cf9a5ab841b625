#include "app/scene_game.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "core/log.hpp"
#include "gameplay/game_functions.hpp"
#include "gameplay/game_progress.hpp"
#include "scene/files/scene_path.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/scene_requests.hpp"
#include "scene/scene_stack.hpp"
#include "tests/app/projects/platformer.hpp"

namespace plumb {
namespace {

std::uint64_t hashAfter(const std::string& scene, int ticks) {
    SceneGame game{platformer(), scene};
    game.assets.logging = false;
    game.onCreate();
    EXPECT_FALSE(game.failure());
    std::size_t moved = 0;
    for (int i = 0; i < ticks; ++i) {
        InputFrame frame;
        frame.set(Key::Right, i % 90 < 70);
        frame.set(Key::Space, i % 45 < 12);
        tickGame(game, frame);
        moved += movedEntities(game.world);
    }
    EXPECT_GT(moved, 0u) << "no entity of this scene moves";
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

TEST(SceneGame, aSecondAfterAHundredSwitchesOnlyAssetsInUseAreLoaded) {
    const auto settled = [](SceneGame& game) {
        game.assets.logging = false;
        game.onCreate();
        for (int i = 0; i < 61; ++i) tickGame(game, InputFrame{});
    };
    SceneGame fresh{platformer(), "level1"};
    settled(fresh);
    SceneGame game{platformer(), "level1"};
    settled(game);
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(
            game.openScene(i % 2 == 0 ? "scenes/level2.scene.json" : "scenes/level1.scene.json").ok());
        for (int k = 0; k < i % 5; ++k) tickGame(game, InputFrame{});
    }
    // assets of the previous scene are kept for one second
    EXPECT_GT(game.assets.size(), fresh.assets.size());
    const std::size_t loads = game.assets.loadCount();
    for (int i = 0; i < 61; ++i) tickGame(game, InputFrame{});

    EXPECT_EQ(game.assets.size(), fresh.assets.size());
    EXPECT_EQ(game.assets.byteCount(), fresh.assets.byteCount());
    EXPECT_EQ(game.assets.loadCount(), loads);
}

/// Plays level 1 for 400 ticks and returns the states; `before(tick)` may act between ticks.
template <class Before>
std::vector<std::uint64_t> played(SceneGame& game, Before before) {
    game.assets.logging = false;
    game.onCreate();
    std::vector<std::uint64_t> states;
    for (int i = 0; i < 400; ++i) {
        before(i);
        InputFrame frame;
        frame.set(Key::Right, i % 90 < 70);
        frame.set(Key::Space, i % 45 < 12);
        tickGame(game, frame);
        const std::uint64_t tick = std::exchange(game.world.tick, 0);
        states.push_back(game.world.hash());
        game.world.tick = tick;
    }
    return states;
}

TEST(SceneGame, pausingDoesNotChangeTheGame) {
    SceneGame plain{platformer(), "level1"};
    const std::vector<std::uint64_t> expected = played(plain, [](int) {});

    SceneGame game{platformer(), "level1"};
    std::size_t most = 0;
    const auto press = [&game](Key key, const InputFrame& held) {
        InputFrame frame = held;
        frame.set(key, true);
        tickGame(game, frame);
    };
    const std::vector<std::uint64_t> states = played(game, [&](int i) {
        if (i % 40 != 39) return;
        const InputFrame held = game.input.frame();
        const InputFrame before = game.input.previousFrame();
        // The pause action takes effect only with a tick, so the pause scene is opened directly.
        ASSERT_TRUE(openOverlay(game.world, game.context(), game.project().pauseScene).ok());
        for (int k = 0; k < i; ++k) press(Key::Right, {});
        most = std::max(most, game.world.resource<LoadedScenes>().scenes.size());
        press(Key::P, {});
        EXPECT_EQ(game.world.resource<LoadedScenes>().scenes.size(), 1u);
        game.input.restore(before, held);
    });

    EXPECT_EQ(most, 2u);
    for (std::size_t i = 0; i < states.size(); ++i) ASSERT_EQ(states[i], expected[i]) << "tick " << i;
}

TEST(SceneGame, thePauseActionOpensTheMenuAndLeadsBackToTheTitle) {
    SceneGame game{platformer(), "level1"};
    game.assets.logging = false;
    game.onCreate();
    const auto press = [&game](Key key) {
        InputFrame frame;
        frame.set(key, true);
        tickGame(game, frame);
        tickGame(game, InputFrame{});
    };
    const auto scenes = [&game] {
        std::vector<std::string> paths;
        for (const LoadedScene& scene : game.world.resource<LoadedScenes>().scenes)
            paths.push_back(scene.path);
        return paths;
    };
    const std::vector<std::string> paused{"scenes/level1.scene.json", "scenes/pause.scene.json"};
    for (int i = 0; i < 60; ++i) tickGame(game, InputFrame{});
    press(Key::Escape);
    EXPECT_EQ(scenes(), paused);
    press(Key::Escape);
    EXPECT_EQ(scenes(), (std::vector<std::string>{"scenes/level1.scene.json"}));
    press(Key::P);
    press(Key::Enter);
    EXPECT_EQ(scenes().size(), 1u) << "the first menu item closes the menu";
    press(Key::P);
    for (int i = 0; i < 3; ++i) press(Key::Down);  // save, then options: there is no game to load
    press(Key::Enter);
    EXPECT_EQ(scenes(), (std::vector<std::string>{"scenes/title.scene.json"}));
    press(Key::P);
    EXPECT_EQ(scenes(), (std::vector<std::string>{"scenes/title.scene.json", "scenes/leave.scene.json"}));
    press(Key::Escape);
    EXPECT_EQ(scenes(), (std::vector<std::string>{"scenes/title.scene.json"}));
}

TEST(SceneGame, theLabelsOfALevelAreCorrectInItsFirstFrame) {
    SceneGame game{platformer(), "scenes/level1.scene.json"};
    game.assets.logging = false;
    game.onCreate();
    tickGame(game, {});
    GameProgress& progress = game.world.resource<GameProgress>();
    const int first = progress.levelCoinsTotal;
    progress.coins = progress.levelCoins = 3;
    progress.levelFinished = true;
    game.world.resource<SceneRequests>().next = game.world.texts().add("scenes/level2.scene.json");
    tickGame(game, {});
    EXPECT_EQ(progress.level, textId("scenes/level2.scene.json"));
    EXPECT_EQ(progress.levelCoins, 0);
    EXPECT_EQ(progress.coinsTotal, first + progress.levelCoinsTotal);
    EXPECT_EQ(progress.coins, 3);

    progress.coins = 5;
    progress.levelCoins = 2;
    game.world.resource<SceneRequests>().reload = true;
    tickGame(game, {});
    EXPECT_EQ(progress.levelCoins, 0);
    EXPECT_EQ(progress.coins, 3) << "a restarted level has its coins again";
    EXPECT_EQ(progress.levelsReached.size(), 2u);
}

TEST(SceneGame, aPlayerWaitingAtTheStartOfALevelIsNotHurt) {
    constexpr int kTicks = 40 * 60;
    for (const std::string& scene : platformerScenes()) {
        SCOPED_TRACE(scene);
        SceneGame game{platformer(), scene};
        game.assets.logging = false;
        game.onCreate();
        for (int tick = 0; tick < kTicks; ++tick) tickGame(game, {});
        EXPECT_EQ(game.world.resource<GameProgress>().deaths, 0);
    }
}

TEST(SceneGame, aMissingSceneIsAnErrorAndTheOldOneContinues) {
    SceneGame game{platformer(), "level1"};
    game.assets.logging = false;
    game.onCreate();
    const std::size_t entities = game.world.entityCount();

    const auto opened = game.openScene("scenes/nowhere.scene.json");

    ASSERT_FALSE(opened.ok());
    EXPECT_FALSE(opened.error().remedy.empty());
    EXPECT_EQ(game.world.entityCount(), entities);
}

std::string currentScene(const SceneGame& game) {
    return game.world.findResource<LoadedScenes>()->scenes.front().path;
}

TEST(SceneGame, namesOfScenesAreTheSameInCodeAndOnTheCommandLine) {
    const std::pair<const char*, const char*> paths[] = {
        {"level2", "scenes/level2.scene.json"},
        {"level2.scene.json", "scenes/level2.scene.json"},
        {"level2.scene.bin", "scenes/level2.scene.bin"},
        {"scenes/level2", "scenes/level2.scene.json"},
        {"scenes/level2.scene.json", "scenes/level2.scene.json"},
        {"caves/level2", "scenes/caves/level2.scene.json"},
        {"caves/level2.scene.json", "caves/level2.scene.json"},
    };
    Game game;
    for (const auto& [name, path] : paths) {
        EXPECT_EQ(scenePath(name), path);
        changeScene(game.world, name);
        EXPECT_EQ(game.world.texts().find(game.world.resource<SceneRequests>().next), path);
    }
}

TEST(SceneGame, theErrorOfAMistypedSceneNamesTheNearestOne) {
    SceneGame game{platformer(), "level1"};
    game.assets.logging = false;
    game.onCreate();
    std::vector<std::string> logged;
    const LogSink before = setLogSink([&](const LogLine& line) { logged.push_back(line.text); });
    changeScene(game.world, "levle2");
    tickGame(game, {});
    showOverlay(game.world, "puase");
    tickGame(game, {});
    setLogSink(before);
    EXPECT_EQ(
        logged,
        (std::vector<std::string>{
            R"(scenes/levle2.scene.json: there is no such file; did you mean "scenes/level2.scene.json"?)",
            R"(scenes/puase.scene.json: there is no such file; did you mean "scenes/pause.scene.json"?)"}));
    EXPECT_EQ(currentScene(game), "scenes/level1.scene.json") << "the old one continues";
}

TEST(SceneGame, anEmptyNameOfASceneIsReportedAsSuch) {
    SceneGame game{platformer(), "level1"};
    game.assets.logging = false;
    game.onCreate();
    std::vector<std::string> logged;
    const LogSink before = setLogSink([&](const LogLine& line) { logged.push_back(line.text); });
    changeScene(game.world, "");
    tickGame(game, {});
    showOverlay(game.world, "");
    tickGame(game, {});
    setLogSink(before);
    ASSERT_EQ(logged.size(), 2u);
    EXPECT_EQ(logged[0],
              "changeScene(\"\"): the name of the scene is empty; write that of a file in scenes/, "
              "e.g. \"level2\"; restartScene() loads the current scene again");
    EXPECT_EQ(logged[1].find("showOverlay(\"\"): the name"), 0u) << logged[1];
    EXPECT_EQ(currentScene(game), "scenes/level1.scene.json");
    EXPECT_EQ(game.world.resource<LoadedScenes>().scenes.size(), 1u);
}

struct HeroDied {};
/// In tick 5 the hero dies, after the turn of the handler; some levels restart in the same tick.
struct Deaths {
    bool restarts = false;
    int received = 0;
};
void openGameOver(World& world, const HeroDied&) {
    ++world.service<Deaths>()->received;
    showOverlay(world, "pause");
}
struct Fate {
    void update(World& world, float) const {
        if (world.tick != 5) return;
        world.emit(HeroDied{});
        if (world.service<Deaths>()->restarts) restartScene(world);
    }
};

TEST(SceneGame, anEventOfALevelIsNotReceivedAfterItsRestart) {
    Module module;
    module.on<HeroDied, openGameOver>();
    module.system<Fate>();
    std::vector<Error> problems;
    const GameContent content{std::move(module), problems};
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    for (const bool restarts : {false, true}) {
        SCOPED_TRACE(restarts);
        Deaths deaths{restarts};
        SceneGame game{platformer(), "level1", std::uint64_t{1}, content};
        game.world.provide(deaths);
        game.assets.logging = false;
        game.onCreate();
        for (int tick = 0; tick < 10; ++tick) tickGame(game, {});
        EXPECT_EQ(deaths.received, restarts ? 0 : 1);
        EXPECT_EQ(game.world.resource<LoadedScenes>().scenes.size(), restarts ? 1u : 2u);
    }
}

TEST(SceneGame, aFieldOfAComponentNamesTheSceneToChangeTo) {
    SceneGame game{platformer(), "level1"};
    game.assets.logging = false;
    game.onCreate();
    changeScene(game.world, SceneId{});
    tickGame(game, {});
    EXPECT_EQ(currentScene(game), "scenes/level1.scene.json") << "an empty field changes nothing";
    changeScene(game.world, SceneId{game.world.texts().add("scenes/level2.scene.json")});
    tickGame(game, {});
    EXPECT_EQ(currentScene(game), "scenes/level2.scene.json");
    showOverlay(game.world, SceneId{game.world.texts().add("scenes/pause.scene.json")});
    tickGame(game, {});
    EXPECT_EQ(game.world.resource<LoadedScenes>().scenes.size(), 2u);
}

}  // namespace
}  // namespace plumb
