#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/event_log.hpp"
#include "app/scene_game.hpp"
#include "app/screen.hpp"
#include "app/sound_output.hpp"
#include "core/log.hpp"
#include "core/profile.hpp"
#include "scene/physics/physics_times.hpp"
#include "tests/app/projects/project_replays.hpp"

// Observing a game must not change it. Each game is played once without an observer; every other run has one,
// and the hash of its state must be the same after each tick.

namespace plumb {
namespace {

constexpr std::size_t kMadeUpTypes = 100;

template <std::size_t N>
struct MadeUp {
    float value = 0.0f;
};

/// A recorded game and its input.
struct Playing {
    const ProjectReplay& row;
    std::vector<InputFrame> input;  ///< one frame per tick
};

/// A function that observes a game between its ticks.
using Onlooker = std::function<void(Game&, std::size_t tick)>;

std::vector<std::uint64_t> hashesOf(const Playing& playing, const Onlooker& look) {
    ProjectGame played{projectOf(playing.row), playing.row.scene};
    SceneGame& game = played.game;
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
    // All types before the first tick, or one more after each tick: the two orders of first use differ from
    // that of the game.
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

/// Changes the log level from tick to tick and discards all lines.
class LogOfTest {
public:
    LogOfTest() : before_{setLogSink([](const LogLine&) {})} {}
    ~LogOfTest() {
        setLogLevel(LogLevel::Note);
        setLogSink(before_);
    }
    LogOfTest(const LogOfTest&) = delete;
    LogOfTest& operator=(const LogOfTest&) = delete;

    static void turn(std::size_t tick) { setLogLevel(static_cast<LogLevel>(tick % 4)); }

private:
    LogSink before_;
};

void expectTheSameWithEach(const Playing& playing) {
    constexpr std::size_t kFrame = 8;  // ticks between drawn frames, because software rendering is slow
    SCOPED_TRACE(playing.row.replay);
    const std::vector<std::uint64_t> alone = hashesOf(playing, [](Game&, std::size_t) {});
    constexpr auto kAll = std::make_index_sequence<kMadeUpTypes>{};

    expectTheSameWith(playing, alone, "queries of unused types before the game begins",
                      [&](Game& game, std::size_t tick) {
                          if (tick == 0) askForMadeUpTypes(game.world, 0, kAll);
                      });
    expectTheSameWith(playing, alone, "queries of unused types while it plays",
                      [&](Game& game, std::size_t tick) {
                          if (tick > 0) askForMadeUpTypes(game.world, tick, kAll);
                      });

    Profile profile;
    expectTheSameWith(playing, alone, "the profiler", [&](Game& game, std::size_t tick) {
        if (tick == 0) game.world.provide(profile);
    });
    EXPECT_FALSE(profile.zones().empty());

    {
        const LogOfTest log;
        expectTheSameWith(playing, alone, "log levels that change", [](Game& game, std::size_t tick) {
            game.assets.logging = tick % 3 != 0;
            game.input.logging = tick % 2 != 0;
            LogOfTest::turn(tick);
        });
    }

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

class Onlookers : public testing::TestWithParam<ProjectReplay> {};

TEST_P(Onlookers, theGameIsTheSameWithThem) {
    expectTheSameWithEach({GetParam(), framesOf(replayOf(GetParam()))});
}

INSTANTIATE_TEST_SUITE_P(Each, Onlookers, testing::ValuesIn(kProjectReplays), testNameOf);

}  // namespace
}  // namespace plumb
