#include <cstdio>
#include <string>
#include <vector>

#include "core/profile.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/app/effects/effect_games.hpp"
#include "tests/bench/callgrind.hpp"
#include "tests/bench/game_effects/game_effects_bench.hpp"

namespace {

constexpr int kWarmUp = 20;  // ticks until all memory is allocated

// The function that callgrind measures.
extern "C" __attribute__((noinline)) void plumbCountedTicks(plumb::Game* game, int ticks) {
    for (int i = 0; i < ticks; ++i) tickGame(*game, plumb::InputFrame{});
}

}  // namespace

namespace plumb::bench {
namespace {

constexpr int kCrates = 30;

/// Returns the effects that have a system.
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

int printTable(CallgrindCounts& counts) {
    int failed = 0;
    std::printf("%-20s%14s%14s%10s\n", "effect", "left out", "unused", "ratio");
    for (const std::size_t row : countedEffects()) {
        const double absent = counts.next(), unused = counts.next();
        const bool good = absent > 0.0 && unused / absent <= 1.01;
        failed += good ? 0 : 1;
        std::printf("%-20s%14.0f%14.0f%10.4f%s\n", std::string{engineEffects().rows()[row].name}.c_str(),
                    absent, unused, unused / absent, good ? "" : "  more than 1 %");
    }
    const double gated = counts.next(), all = counts.next();
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
        all.effects.setProgramPin(engineEffects().rows()[row].name, Pin::On);
    count(gated, quick);
    count(all, quick);
    return 0;
}

int measureUnused(const char* program, bool quick) {
    std::printf("\ninstructions of a game with a pile of %d crates, by callgrind\n", kCrates);
    return countInstructions(program, "plumbCountedTicks", quick, printTable);
}

}  // namespace plumb::bench
