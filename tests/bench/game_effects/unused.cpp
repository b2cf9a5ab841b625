#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/profile.hpp"
#include "scene/physics_state.hpp"
#include "tests/app/effect_games.hpp"
#include "tests/bench/game_effects/game_effects_bench.hpp"

namespace {

constexpr int kWarmUp = 20;  // ticks, until everything has its memory

// What callgrind looks at: it zeroes its counters before and writes them down after each call. Named for C,
// so that the name is known.
extern "C" __attribute__((noinline)) void plumbCountedTicks(plumb::Game* game, int ticks) {
    for (int i = 0; i < ticks; ++i) tickGame(*game, plumb::InputFrame{});
}

}  // namespace

namespace plumb::bench {
namespace {

constexpr int kCrates = 30;

/// The effects that systems run for.
std::vector<std::size_t> countedEffects() {
    std::vector<std::size_t> rows;
    for (const std::size_t row : test::gameEffects()) {
        if (test::hasSystem(row)) rows.push_back(row);
    }
    return rows;
}

void count(test::PileGame& game, bool quick) {
    game.world.resource<PhysicsSettings>().tolerances.sleeping = false;
    game.play(kWarmUp);
    plumbCountedTicks(&game, quick ? 5 : 60);
}

/// The counters of one dump of callgrind. @return 0 when there is none
double instructionsIn(const std::filesystem::path& dump) {
    std::ifstream file{dump};
    for (std::string word; file >> word;) {
        if (word == "totals:" || word == "summary:") {
            double count = 0.0;
            file >> count;
            if (count > 0.0) return count;
        }
    }
    return 0.0;
}

int printTable(const std::filesystem::path& folder) {
    int failed = 0, dump = 0;
    const auto next = [&] { return instructionsIn(folder / ("count." + std::to_string(++dump))); };
    std::printf("%-20s%14s%14s%10s\n", "effect", "left out", "unused", "ratio");
    for (const std::size_t row : countedEffects()) {
        const double absent = next(), unused = next();
        const bool good = absent > 0.0 && unused / absent <= 1.01;
        failed += good ? 0 : 1;
        std::printf("%-20s%14.0f%14.0f%10.4f%s\n", std::string{engineEffects().rows()[row].name}.c_str(),
                    absent, unused, unused / absent, good ? "" : "  more than 1 %");
    }
    const double gated = next(), all = next();
    std::printf("%-20s%14.0f%14.0f%10.4f\n", "all pinned on", gated, all, all / gated);
    return failed == 0 ? 0 : 1;
}

}  // namespace

int runCountedTicks(bool quick) {
    for (const std::size_t row : countedEffects()) {
        const std::string_view effect = engineEffects().rows()[row].name;
        test::PileGame absent{kCrates, effect}, unused{kCrates};
        count(absent, quick);
        count(unused, quick);
    }
    test::PileGame gated{kCrates}, all{kCrates};
    for (const std::size_t row : countedEffects())
        all.effects.setProgram(engineEffects().rows()[row].name, Pin::On);
    count(gated, quick);
    count(all, quick);
    return 0;
}

int measureUnused(const char* program, bool quick) {
    if (std::system("valgrind --version > /dev/null 2>&1") != 0) {
        std::printf("valgrind is not installed: instructions are not counted\n");
        return 77;
    }
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("plumb_game_effects_" + std::to_string(std::rand()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::printf("\ninstructions of a game with a pile of %d crates, by callgrind\n", kCrates);
    const std::string command =
        "valgrind --tool=callgrind --zero-before='plumbCountedTicks' --dump-after='plumbCountedTicks'"
        " --callgrind-out-file='" +
        (folder / "count").string() + "' '" + program + "' counted" + (quick ? " --quick" : "") +
        " > /dev/null 2>&1";
    const bool counted = std::system(command.c_str()) == 0;
    if (!counted) std::printf("callgrind did not run\n");
    const int result = counted ? printTable(folder) : 1;
    std::filesystem::remove_all(folder);
    return result;
}

}  // namespace plumb::bench
