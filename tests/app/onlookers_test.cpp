#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/event_log.hpp"
#include "app/screen.hpp"
#include "app/sound_output.hpp"
#include "core/profile.hpp"
#include "gameplay/game_progress.hpp"
#include "input/recorder.hpp"
#include "scene/physics_times.hpp"
#include "tests/app/platformer.hpp"
#include "tests/app/playground.hpp"

// Looking at a game does not change it. Each game here is played once alone; every other run has an
// onlooker, and the hash of its state must be the same after each tick.

namespace plumb {
namespace {

constexpr std::size_t kMadeUpTypes = 100;

template <std::size_t N>
struct MadeUp {
    float value = 0.0f;
};

/// A game that is played without a person.
struct Playing {
    const char* project;
    std::vector<InputFrame> input;  ///< one frame a tick
};

/// From the title through all levels.
Playing platformerReplay() {
    Playing playing{"platformer", {}};
    const Result<Replay> replay = loadReplay(test::sourceFolder() / "tests/replay/platformer.replay");
    EXPECT_TRUE(replay.ok());
    ReplayPlayer player{*replay};
    while (const InputFrame* frame = player.next()) playing.input.push_back(*frame);
    return playing;
}

/// From the menu into its first scenes and back, with a hand that drags.
Playing menuAndScenes(const char* project) {
    constexpr int kScenes = 6;
    constexpr int kVisit = 120;  // ticks
    Playing playing{project, {}};
    const auto press = [&](Key key) {
        InputFrame frame;
        frame.set(key, true);
        playing.input.insert(playing.input.end(), 2, frame);
        playing.input.insert(playing.input.end(), 4, InputFrame{});
    };
    for (int scene = 0; scene < kScenes; ++scene) {
        for (int i = 0; i < scene; ++i) press(Key::Down);
        press(Key::Enter);
        for (int tick = 0; tick < kVisit; ++tick) {
            InputFrame frame;
            frame.set(Key::Right, tick % 60 > 30);
            frame.set(Key::Space, tick % 45 == 20);
            if (tick > kVisit / 2) frame.mouseButtons = 1;
            frame.setMouse({static_cast<float>(320 + tick), 300.0f});
            playing.input.push_back(frame);
        }
        press(Key::Escape);
    }
    return playing;
}

/// What looks at a game between its ticks.
using Onlooker = std::function<void(Game&, std::size_t tick)>;

std::vector<std::uint64_t> hashesOf(const Playing& playing, const Onlooker& look) {
    Result<Project> project = loadProject(test::sourceFolder() / "projects" / playing.project);
    EXPECT_TRUE(project.ok());
    SceneGame game{std::move(*project)};
    game.assets.logging = false;
    look(game, 0);
    game.onCreate();
    std::vector<std::uint64_t> hashes;
    for (const InputFrame& frame : playing.input) {
        tickGame(game, frame);
        look(game, hashes.size() + 1);
        hashes.push_back(game.world.hash());
    }
    return hashes;
}

template <std::size_t... N>
void askForMadeUpTypes(const World& world, std::size_t tick, std::index_sequence<N...>) {
    // All before the game begins, or one more each tick: both orders of first use are other ones.
    ((tick == 0 || tick % kMadeUpTypes == N ? static_cast<void>(world.query<const MadeUp<N>>().count())
                                            : void()),
     ...);
}

void expectTheSameWith(const Playing& playing, const std::vector<std::uint64_t>& alone, const char* onlooker,
                       const Onlooker& look) {
    SCOPED_TRACE(onlooker);
    const std::vector<std::uint64_t> hashes = hashesOf(playing, look);
    ASSERT_EQ(hashes.size(), alone.size());
    const auto differs = std::mismatch(alone.begin(), alone.end(), hashes.begin()).first;
    EXPECT_EQ(differs, alone.end()) << "the first tick that differs: " << differs - alone.begin() + 1;
}

void expectTheSameWithEach(const Playing& playing) {
    constexpr std::size_t kFrame = 8;  // ticks between pictures: a picture in software takes long
    SCOPED_TRACE(playing.project);
    const std::vector<std::uint64_t> alone = hashesOf(playing, [](Game&, std::size_t) {});
    constexpr auto kAll = std::make_index_sequence<kMadeUpTypes>{};

    expectTheSameWith(playing, alone, "types that no entity has, asked for before the game begins",
                      [&](Game& game, std::size_t tick) {
                          if (tick == 0) askForMadeUpTypes(game.world, 0, kAll);
                      });
    expectTheSameWith(playing, alone, "types that no entity has, asked for while it plays",
                      [&](Game& game, std::size_t tick) {
                          if (tick > 0) askForMadeUpTypes(game.world, tick, kAll);
                      });

    Profile profile;
    expectTheSameWith(playing, alone, "the profiler", [&](Game& game, std::size_t tick) {
        if (tick == 0) game.world.provide(profile);
    });
    EXPECT_FALSE(profile.zones().empty());

    PhysicsShown all;
    all.layers = *physicsLayersNamed("all");
    PhysicsTimes times;
    all.times = &times;
    Result<std::unique_ptr<Screen>> opened =
        Screen::open({"test", 320, 180, false, {320.0f, 180.0f}, WindowScale::Fit});
    ASSERT_TRUE(opened) << opened.error().text();
    EventLog events;
    expectTheSameWith(playing, alone, "a window that shows the physics", [&](Game& game, std::size_t tick) {
        times.watch(game.world, true);
        events.write(game.world);
        if (tick % kFrame == 0) (*opened)->draw(game.world, game.assets, 0.5f, all);
    });
    EXPECT_GT((*opened)->drawCalls(), 0) << "nothing was drawn";
    opened->reset();
}

TEST(Onlookers, thePlatformerIsTheSameGameWithThem) { expectTheSameWithEach(platformerReplay()); }

TEST(Onlookers, thePlaygroundIsTheSameGameWithThem) {
    expectTheSameWithEach(menuAndScenes("physics-playground"));
}

TEST(Onlookers, theLabIsTheSameGameWithThem) { expectTheSameWithEach(menuAndScenes("physics-lab")); }

}  // namespace
}  // namespace plumb
