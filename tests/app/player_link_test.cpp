#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "app/player.hpp"
#include "core/log.hpp"
#include "core/random.hpp"
#include "input/replay_link.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

/// What a run of the player has printed.
struct Played {
    int code = 0;
    std::string link;
    std::string hash;
    std::string error;  ///< the last one
};

std::string lineAfter(const std::string& text, const std::string& mark) {
    const std::size_t at = text.find(mark);
    if (at == std::string::npos) return {};
    return text.substr(at + mark.size(), text.find('\n', at) - at - mark.size());
}

/// Plays the platformer without a window.
Played play(PlayerOptions options) {
    Played played;
    const LogSink before = setLogSink([&](const LogLine& line) {
        if (line.level == LogLevel::Error) played.error = line.text;
    });
    options.project = (test::sourceFolder() / "projects/platformer").string();
    options.headless = options.hash = options.printLink = true;
    options.threads = 1;
    testing::internal::CaptureStdout();
    played.code = playProject(options, {});
    const std::string printed = testing::internal::GetCapturedStdout();
    setLogSink(before);
    played.link = lineAfter(printed, "link: ");
    played.hash = lineAfter(printed, "hash: ");
    return played;
}

Played playLink(std::string link, std::int64_t frames = -1) {
    PlayerOptions options;
    options.link = std::move(link);
    options.frames = frames;
    return play(options);
}

/// Plays the recorded game of the project, up to a tick.
Played playRecorded(std::int64_t frames) {
    PlayerOptions options;
    options.replay = (test::sourceFolder() / "tests/replay/platformer.replay").string();
    options.frames = frames;
    return play(options);
}

TEST(PlayerLink, theLinkOfARecordedGameEndsInTheSameStateAtEveryLength) {
    for (const std::int64_t frames : {0, 1, 2, 59, 300, 800, -1}) {
        SCOPED_TRACE(frames);
        const Played recorded = playRecorded(frames);
        ASSERT_EQ(recorded.code, 0);
        const Played again = playLink("https://example.org/game/" + recorded.link);
        EXPECT_EQ(again.code, 0) << again.error;
        EXPECT_EQ(again.hash, recorded.hash);
        EXPECT_EQ(again.link, recorded.link);
    }
}

TEST(PlayerLink, randomGamesEndInTheSameState) {
    const test::TemporaryFolder folder;
    PlayerOptions options;
    options.replay = (folder.path / "random.replay").string();
    std::string before;
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Recorder recorder;
        recorder.replay.seed = seed;
        recorder.replay.scene = "scenes/level1.scene.json";
        InputFrame frame;
        while (recorder.ticks() < 200) {
            constexpr std::array kKeys{Key::Left, Key::Right, Key::Space, Key::Down, Key::Up, Key::Enter};
            const Key key = kKeys[random.below(kKeys.size())];
            frame.set(key, !frame.has(key));
            frame.setMouse({random.between(0.0f, 640.0f), random.between(0.0f, 360.0f)});
            for (std::uint32_t n = 1 + random.below(30); n > 0; --n) recorder.record(frame);
        }
        ASSERT_TRUE(writeFile(options.replay, writeReplay(recorder.replay)));
        const Played recorded = play(options);
        ASSERT_EQ(recorded.code, 0) << recorded.error;
        const Played again = playLink(recorded.link);
        EXPECT_EQ(again.code, 0) << again.error;
        EXPECT_EQ(again.hash, recorded.hash);
        EXPECT_NE(again.hash, before) << "the runs differ";
        before = again.hash;
    }
}

TEST(PlayerLink, aLinkFromAnotherStateEndsWithAnError) {
    Replay replay = *replayOfLink(playRecorded(120).link);
    ASSERT_EQ(replay.checkpoints.size(), 1u);
    replay.checkpoints[0].hash ^= 1;
    const Played other = playLink(*linkOf(replay));
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.error.find("link: the simulation differs from the recorded one at tick 120"),
              std::string::npos)
        << other.error;
}

TEST(PlayerLink, linksOfOtherProjectsAndDamagedOnesAreNotPlayed) {
    Replay replay;
    replay.project = "Sky Caves";
    const Played other = playLink(*linkOf(replay));
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.error.find("link: it was recorded by the project \"Sky Caves\""), std::string::npos)
        << other.error;
    const Played damaged = playLink("#r=hello");
    EXPECT_EQ(damaged.code, 1);
    EXPECT_NE(damaged.error.find("link: the link is damaged or incomplete"), std::string::npos)
        << damaged.error;
}

}  // namespace
}  // namespace plumb
