#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/bench/effects/effects_bench.hpp"
#include "tests/physics/effect_scenes.hpp"

namespace {

constexpr int kWarmUp = 20;  // steps, until everything has its memory

// What callgrind looks at: it zeroes its counters before and writes them down after each call. Named for C,
// so that the name is known.
extern "C" __attribute__((noinline)) void plumbCountedSteps(plumb::physics::World* world, int steps) {
    for (int i = 0; i < steps; ++i) plumb::physics::step(*world, plumb::bench::kTick);
}

}  // namespace

namespace plumb::bench {

namespace {

using physics::Effect;
using physics::World;

/// How an effect is present in a scene that nobody calls for it in.
enum Variant { kAbsent, kUnused, kPinnedOn, kVariants };

World makeScene(Effect effect, int variant) {
    World world = physics::test::makeSceneWithout(effect);
    if (variant == kAbsent) world.manifest.pinnedOff |= physics::Manifest::bit(effect);
    if (variant == kPinnedOn) physics::test::pinOn(world, effect);
    return world;
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

bool count(const std::string& program, const std::filesystem::path& folder, bool quick) {
    const std::string command =
        "valgrind --tool=callgrind --zero-before='plumbCountedSteps'"
        " --dump-after='plumbCountedSteps' --callgrind-out-file='" +
        (folder / "count").string() + "' '" + program + "' counted" + (quick ? " --quick" : "") +
        " > /dev/null 2>&1";
    return std::system(command.c_str()) == 0;
}

int printTable(const std::filesystem::path& folder) {
    std::printf("%-16s%14s%14s%10s%14s%10s\n", "effect", "left out", "unused", "ratio", "pinned on", "ratio");
    int failed = 0, dump = 0;
    for (const Effect effect : physics::test::allEffects()) {
        double counts[kVariants];
        for (double& count : counts) count = instructionsIn(folder / ("count." + std::to_string(++dump)));
        const double unused = counts[kUnused] / counts[kAbsent], pinned = counts[kPinnedOn] / counts[kAbsent];
        const bool good = counts[kAbsent] > 0.0 && unused <= 1.01;
        failed += good ? 0 : 1;
        const std::string name{physics::nameOf(effect)};
        std::printf("%-16s%14.0f%14.0f%10.4f%14.0f%10.4f%s\n", name.c_str(), counts[kAbsent], counts[kUnused],
                    unused, counts[kPinnedOn], pinned, good ? "" : "  more than 1 %");
    }
    return failed == 0 ? 0 : 1;
}

}  // namespace

int runCounted(bool quick) {
    for (const Effect effect : physics::test::allEffects()) {
        for (int variant = 0; variant < kVariants; ++variant) {
            World world = makeScene(effect, variant);
            for (int i = 0; i < kWarmUp; ++i) physics::step(world, kTick);
            plumbCountedSteps(&world, quick ? 5 : 60);
        }
    }
    return 0;
}

int measureCost(const char* program, bool quick) {
    if (std::system("valgrind --version > /dev/null 2>&1") != 0) {
        std::printf("valgrind is not installed: instructions are not counted\n");
        return 77;
    }
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("plumb_effects_" + std::to_string(std::rand()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::printf("\ninstructions of a pile of %d, by callgrind\n", physics::test::kCrates);
    const bool counted = count(program, folder, quick);
    if (!counted) std::printf("callgrind did not run\n");
    const int result = counted ? printTable(folder) : 1;
    std::filesystem::remove_all(folder);
    return result;
}

}  // namespace plumb::bench
