// Crashes games in child processes and plays the file that each leaves: it must end in the same tick, with
// the same state and the same report. PLUMB_CRASHES is the number of crashes.

#ifndef _WIN32

#include "app/recording/crash_file.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <limits>
#include <new>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "app/player.hpp"
#include "core/assert.hpp"
#include "core/crash.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "gameplay/game_functions.hpp"
#include "tests/support/allocations.hpp"
#include "tests/support/crashes.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

using test::overflow, test::writeToNull;

// ---- ways to crash

void recur() {
    volatile int depth = 0;
    static_cast<void>(overflow(&depth));
}
void allocateAll() {
    volatile std::size_t much = std::numeric_limits<std::ptrdiff_t>::max() / 2;
    volatile char* memory = new char[much];
    memory[0] = 1;
}
void failAssert() { failAssertion("a body has a mass", "bodies.cpp", 12); }
void throwError() { throw std::runtime_error{"no such level"}; }
void invalidInstruction() { __builtin_trap(); }
void sendBus() { std::raise(SIGBUS); }
void hang() {
    for (volatile int forever = 1; forever != 0;) {
    }
}

struct Kind {
    const char* name;
    void (*crash)();
    const char* expected;  // part of the report
    bool throws = false;
};
constexpr std::array kKinds {
    Kind{"null pointer", writeToNull, "SIGSEGV, a wrong access to memory: a null pointer"},
        Kind{"recursion", recur, "SIGSEGV, a wrong access to memory: the stack is full"},
        Kind{"abort", std::abort, "SIGABRT"},
        Kind{"exception", throwError, "not caught, or damaged memory: no such level", true},
        Kind{"assertion", failAssert, "damaged memory: a body has a mass"},
        Kind{"memory", allocateAll, "damaged memory: out of memory", true},
#if defined(__x86_64__) && defined(__GLIBC__)
        Kind{"invalid instruction", invalidInstruction, "SIGILL"},
#endif
        Kind{"bus error", sendBus, "SIGBUS"},
};
constexpr Kind kHang{"hang", hang, "a tick takes more than 5 s"};
constexpr std::array kSent{SIGSEGV, SIGABRT, SIGBUS, SIGFPE};

struct Game {
    const char* project;
    const char* replay;  ///< its input
};
constexpr std::array kGames{Game{"platformer", "platformer"}, Game{"physics-playground", "playground"},
                            Game{"physics-playground", "pinball"}, Game{"physics-lab", "lab"}};

/// Crashes in a tick, after it has printed the state.
struct CrashingSystem {
    static std::uint64_t at;
    static const Kind* kind;

    void update(World& world, float) const {
        if (world.tick != at || kind == nullptr) return;
        std::printf("crash %s\n", hexText(world.hash()).c_str());
        kind->crash();
    }
};
std::uint64_t CrashingSystem::at = 0;
const Kind* CrashingSystem::kind = nullptr;

/// Saves the game at the end of a tick, and loads it once at the end of another one.
struct LoadingSystem {
    static std::uint64_t saveAt, loadAt;

    void update(World& world, float) const {
        if (loadAt == 0) return;
        if (world.tick == saveAt) saveGame(world, 3);
        if (world.tick == loadAt) loadGame(world, 3);
        if (world.tick == loadAt) loadAt = 0;
    }
};
std::uint64_t LoadingSystem::saveAt = 0;
std::uint64_t LoadingSystem::loadAt = 0;

/// Returns the line of a text that starts so; empty: none.
std::string lineOf(const std::string& text, std::string_view start) {
    const std::size_t at = text.find("\n" + std::string{start});
    return at == std::string::npos ? std::string{} : text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

[[noreturn]] void playAndExit(const PlayerOptions& options) {
    reportCrashes("");
    Module code;
    code.system<LoadingSystem>();
    code.system<CrashingSystem>();
    std::_Exit(playProject(options, code));
}

/// A folder for the reports and the output of child processes.
class CrashFiles : public test::CrashTest {
protected:
    /// Plays a project in a child process, which crashes as CrashingSystem says.
    /// @param sent  signal that is sent to it; 0: none
    /// @param tick  the signal is sent after its hash was printed
    /// @return how the process ended, see waitpid()
    int play(const PlayerOptions& options, int sent = 0, std::uint64_t tick = 0) {
        std::fflush(stdout);
        std::filesystem::remove(folder_.path / "output");
        const pid_t child = ::fork();
        if (child == 0) {
            const int output = ::open((folder_.path / "output").c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644);
            ::dup2(output, STDOUT_FILENO);
            ::dup2(output, STDERR_FILENO);
            std::setvbuf(stdout, nullptr, _IOLBF, 1 << 16);
            // On another thread, because Google Test catches exceptions on this one.
            if (CrashingSystem::kind != nullptr && CrashingSystem::kind->throws)
                std::thread{playAndExit, options}.join();
            playAndExit(options);
        }
        int status = 0;
        const std::string line = "hash " + std::to_string(tick) + ":";
        while (sent != 0 && lineOf(output(), line).empty()) {
            if (::waitpid(child, &status, WNOHANG) == child) return status;
            ::usleep(200);
        }
        if (sent != 0) ::kill(child, sent);
        ::waitpid(child, &status, 0);
        return status;
    }
    [[nodiscard]] std::string output() const {
        const Result<std::string> text = readFile(folder_.path / "output");
        return text ? *text : std::string{};
    }
    [[nodiscard]] Path reports() const { return folder_.path / "reports"; }
    /// The files of crashes, and removes them from the list of the next call.
    [[nodiscard]] std::vector<std::string> files() const { return filesBelow(reports(), ""); }

    /// The options of a game whose input is a replay with this seed.
    PlayerOptions optionsOf(const Game& game, std::uint64_t seed) {
        Result<Replay> replay =
            loadReplay(test::sourceFolder() / "tests/replay" / (std::string{game.replay} + ".replay"));
        EXPECT_TRUE(replay.ok());
        replay->seed = seed;
        replay->checkpoints.clear();
        ticks = replay->ticks();
        const Path input = folder_.path / "input.replay";
        EXPECT_TRUE(writeFile(input, writeReplay(*replay)).ok());
        PlayerOptions options;
        options.project = (test::sourceFolder() / "projects" / game.project).string();
        options.headless = true;
        options.threads = 1;
        options.replay = input.string();
        options.crashReports = reports().string();
        return options;
    }
    /// The options that play the report.
    [[nodiscard]] PlayerOptions replayOf(const PlayerOptions& crashed, const std::string& file) const {
        PlayerOptions options = crashed;
        options.replay = (reports() / file).string();
        options.crashReports.clear();
        return options;
    }
    void clear() const { std::filesystem::remove_all(reports()); }

    std::uint64_t ticks = 0;  ///< of the replay in the options

private:
    test::TemporaryFolder folder_{test::memoryFolder()};
};

/// Returns the innermost functions of a back trace on the terminal, without addresses.
std::string traceOf(const std::string& text) {
    std::string trace;
    std::size_t at = text.find("back trace");
    for (int i = 0; i < 3 && at != std::string::npos; ++i) {
        at = text.find('\n', at + 1);
        if (at == std::string::npos) break;
        const std::string line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
        trace += line.substr(0, line.find('[')) + "\n";
    }
    return trace;
}

class CrashFilesFrom : public CrashFiles {
protected:
    void crashInside(const Kind& kind, Random& random) {
        const Game& game = kGames[random.below(kGames.size())];
        const PlayerOptions options = optionsOf(game, random.below(1000));
        CrashingSystem::kind = &kind;
        CrashingSystem::at = 1 + random.below(static_cast<std::uint32_t>(ticks));
        SCOPED_TRACE(std::string{kind.name} + " in tick " + std::to_string(CrashingSystem::at) + " of " +
                     game.replay);
        const int ended = play(options);
        const std::string crash = output();
        ASSERT_EQ(files().size(), 1u) << crash;
        EXPECT_NE(crash.find(kind.expected), std::string::npos) << crash;

        const Result<Replay> replay = loadReplay(reports() / files().front());
        ASSERT_TRUE(replay.ok()) << replay.error().text();
        EXPECT_EQ(replay->ticks(), CrashingSystem::at);
        EXPECT_EQ(replay->crash.running, "CrashingSystem");
        EXPECT_NE(replay->crash.what.find(kind.expected), std::string::npos);

        EXPECT_EQ(play(replayOf(options, files().front())), ended);
        const std::string again = output();
        EXPECT_EQ(lineOf(again, "crash "), lineOf(crash, "crash ")) << again;
        EXPECT_NE(lineOf(crash, "crash "), "");
        EXPECT_EQ(lineOf(again, "plumb: the program"), lineOf(crash, "plumb: the program"));
        // A hang is found somewhere in its loop.
        if (&kind != &kHang) {
            EXPECT_EQ(traceOf(again), traceOf(crash));
        }
        EXPECT_NE(again.find("during tick " + std::to_string(CrashingSystem::at) + " of " +
                             std::to_string(CrashingSystem::at) + " of the replay"),
                  std::string::npos)
            << again;
        EXPECT_EQ(files().size(), 1u) << "a replay leaves no file";
        clear();
    }

    void crashFromOutside(int signal, Random& random) {
        const Game& game = kGames[random.below(kGames.size())];
        PlayerOptions options = optionsOf(game, random.below(1000));
        options.hashEvery = 1;
        CrashingSystem::kind = nullptr;
        const std::uint64_t tick = 1 + random.below(static_cast<std::uint32_t>(ticks * 3 / 4));
        SCOPED_TRACE(std::string{game.replay} + " and signal " + std::to_string(signal) + " after tick " +
                     std::to_string(tick));
        const int ended = play(options, signal, tick);
        const std::string crash = output();
        if (WIFEXITED(ended)) return;  // it was at its end before the signal came
        ASSERT_TRUE(WIFSIGNALED(ended) && WTERMSIG(ended) == signal) << crash;
        ASSERT_EQ(files().size(), 1u) << crash;

        const Result<Replay> replay = loadReplay(reports() / files().front());
        ASSERT_TRUE(replay.ok()) << replay.error().text();
        EXPECT_EQ(play(replayOf(options, files().front())), 0);
        const std::string again = output();
        // The signal may come between the tick and its line.
        const std::string last = "hash " + std::to_string(replay->ticks() - 1) + ":";
        if (replay->ticks() > 1) {
            EXPECT_NE(lineOf(crash, last), "") << crash;
            EXPECT_EQ(lineOf(again, last), lineOf(crash, last));
        }
        EXPECT_NE(lineOf(again, "hash " + std::to_string(replay->ticks()) + ":"), "");
        EXPECT_NE(again.find("It has not crashed again"), std::string::npos);
        clear();
        ++outside;
    }

    int outside = 0;  ///< crashes from outside in the middle of a game
};

TEST_F(CrashFilesFrom, randomCrashesEndInTheSameTickWithTheSameState) {
    const char* number = std::getenv("PLUMB_CRASHES");
    const int crashes = number != nullptr ? std::atoi(number) : 16;
    Random random = Random::seeded(23);
    for (int i = 0; i < crashes && !HasFatalFailure(); ++i) {
        const auto which = static_cast<std::size_t>(i / 2);
        if (i % 2 == 0) {
            crashInside(number != nullptr && which % 25 == 24 ? kHang : kKinds[which % kKinds.size()],
                        random);
        } else {
            const int before = outside;
            for (int tries = 0; tries < 9 && outside == before; ++tries)
                crashFromOutside(kSent[which % kSent.size()], random);
        }
    }
    EXPECT_EQ(outside, crashes / 2);
}

TEST_F(CrashFiles, afterASavedGameWasLoadedBeginWithIt) {
    Random random = Random::seeded(29);
    for (int round = 0; round < 4; ++round) {
        PlayerOptions options = optionsOf(kGames[static_cast<std::size_t>(round)], 1);
        options.replay.clear();
        options.frames = 400;
        options.saves = (reports().parent_path() / "data").string();
        LoadingSystem::saveAt = 20 + random.below(100);
        LoadingSystem::loadAt = LoadingSystem::saveAt + 1 + random.below(100);
        CrashingSystem::kind = kKinds.data();
        CrashingSystem::at = LoadingSystem::loadAt + 1 + random.below(100);
        SCOPED_TRACE(format("saved at {}, loaded at {}, crash at {}", LoadingSystem::saveAt,
                            LoadingSystem::loadAt, CrashingSystem::at));
        const int ended = play(options);
        const std::string crash = output();
        ASSERT_EQ(files().size(), 1u) << crash;
        EXPECT_NE(crash.find("Loaded slot 3"), std::string::npos) << crash;
        const Result<Replay> replay = loadReplay(reports() / files().front());
        ASSERT_TRUE(replay) << replay.error().text();
        EXPECT_EQ(replay->ticks(), CrashingSystem::at - LoadingSystem::saveAt);

        LoadingSystem::loadAt = 0;
        std::filesystem::remove_all(options.saves);
        options.saves.clear();
        options.frames = -1;
        EXPECT_EQ(play(replayOf(options, files().front())), ended);
        const std::string again = output();
        EXPECT_NE(lineOf(crash, "crash "), "") << crash;
        EXPECT_EQ(lineOf(again, "crash "), lineOf(crash, "crash ")) << again;
        clear();
    }
}

// ---- the file

class CrashFileText : public testing::Test {
protected:
    [[nodiscard]] std::string written(const CrashFile& file) const {
        const Path path = folder_.path / "report";
        const int handle = ::open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644);
        CrashOutput out{handle};
        file.writeFile(out, {"SIGSEGV, a wrong access", "a null pointer", "MoveSystem"});
        ::close(handle);
        return *readFile(path);
    }
    /// The input of a tick in which something is pressed or released.
    static InputFrame inputOf(int tick) {
        InputFrame frame;
        frame.set(Key::Space, tick / 5 % 2 == 0);
        frame.mouseX = static_cast<std::int16_t>(tick % 100);
        return frame;
    }

    test::TemporaryFolder folder_;
    Replay start_{.project = "Sky\nCaves", .engine = "0.1.0", .scene = "scenes/a.scene.json", .seed = 42};
};

TEST_F(CrashFileText, isAReplayOfAllTicksWithTheLastHashes) {
    constexpr int kTicks = 300;
    CrashFile file{start_, folder_.path, "in a window", nullptr};
    Recorder expected;
    for (int tick = 0; tick < kTicks; ++tick) {
        file.tickBegins(inputOf(tick));
        expected.record(inputOf(tick));
        if (tick + 1 == kTicks) break;
        file.tickEnds();
        file.check(static_cast<std::uint64_t>(tick) * 3);
    }
    const std::string text = written(file);
    const Result<Replay> replay = parseReplay(text, "crash.replay");
    ASSERT_TRUE(replay.ok()) << replay.error().text();
    EXPECT_EQ(replay->project, "Sky Caves");
    EXPECT_EQ(replay->scene, "scenes/a.scene.json");
    EXPECT_EQ(replay->seed, 42u);
    EXPECT_EQ(replay->runs, expected.replay.runs);
    EXPECT_EQ(replay->crash,
              (RecordedCrash{"SIGSEGV, a wrong access: a null pointer", "MoveSystem", buildId()}));
    ASSERT_EQ(replay->checkpoints.size(), 255u);
    EXPECT_EQ(replay->checkpoints.back(), (HashCheck{299, 298 * 3}));
    EXPECT_EQ(replay->checkpoints.front(), (HashCheck{45, 44 * 3}));
    EXPECT_NE(text.find("\nduring tick 300\nin a window\n"), std::string::npos);
    EXPECT_EQ(text.find("were changed"), std::string::npos);
}

TEST_F(CrashFileText, saysWhatHasChangedTheGame) {
    CrashFile file{start_, folder_.path, "in a window", nullptr};
    for (int tick = 0; tick < 7; ++tick) file.tickBegins({}), file.tickEnds();
    file.changed("files of the project were changed");
    file.tickBegins({}), file.tickEnds();
    file.changed("keys were changed");
    const std::string text = written(file);
    EXPECT_NE(text.find("\nafter tick 8\n"), std::string::npos);
    EXPECT_NE(text.find("After tick 7, files of the project were changed: the replay may differ"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("keys were"), std::string::npos) << "the replay is exact up to the first change";
}

TEST_F(CrashFileText, containsTheSavedGameThatTheRunBeganWith) {
    Random random = Random::seeded(17);
    for (const std::uint32_t size : {1u, 1000u, static_cast<std::uint32_t>(CrashFile::kMostState)}) {
        start_.keys = R"({"actions":{"Jump":["K"]},"axes":{}})";
        start_.state.clear();
        for (std::uint32_t i = 0; i < size; ++i) start_.state += static_cast<char>(random.next());
        CrashFile file{start_, folder_.path, "in a window", nullptr};
        for (int tick = 0; tick < 20; ++tick) file.tickBegins(inputOf(tick));
        std::string text = written(file);
        const Result<Replay> replay = parseReplay(text, "crash.replay");
        ASSERT_TRUE(replay) << replay.error().text();
        EXPECT_EQ(replay->state, start_.state);
        EXPECT_EQ(replay->keys, start_.keys);
        EXPECT_EQ(replay->ticks(), 20u);
        text.resize(text.find("state ") + 8 + size / 2);
        EXPECT_FALSE(parseReplay(text, "crash.replay")) << "the state is incomplete";
    }
}

TEST_F(CrashFileText, isBelow5MegabytesAndSaysThatTheMemoryWasFull) {
    CrashFile file{start_, folder_.path, "in a window", nullptr};
    for (int tick = 0; tick < 400'000; ++tick) {
        InputFrame frame;
        for (PadFrame& pad : frame.pads) pad.axes.fill(static_cast<std::int16_t>(tick % 2 * 32767));
        file.tickBegins(frame), file.tickEnds(), file.check(1);
    }
    const std::string text = written(file);
    EXPECT_LT(text.size(), 5'000'000u);
    EXPECT_GT(text.size(), 4'900'000u);
    EXPECT_NE(text.find("the replay ends before the crash"), std::string::npos);
    EXPECT_TRUE(parseReplay(text, "crash.replay").ok());
}

TEST_F(CrashFileText, allocatesNothingWhileTheGameRuns) {
    CrashFile file{start_, folder_.path, "in a window", nullptr};
    const std::size_t before = test::allocations().made;
    for (int tick = 0; tick < 5000; ++tick) {
        file.tickBegins(inputOf(tick));
        file.tickEnds();
        if (tick % 10 == 0) file.check(1);
    }
    EXPECT_EQ(test::allocations().made, before);
}

}  // namespace
}  // namespace plumb

#endif
