#include <cstdio>
#include <string>

#include "tests/bench/callgrind.hpp"
#include "tests/bench/effects/effects_bench.hpp"
#include "tests/physics/support/effect_scenes.hpp"

namespace {

constexpr int kWarmUp = 20;  // steps until all memory is allocated

// The function that callgrind measures.
extern "C" __attribute__((noinline)) void plumbCountedSteps(plumb::physics::World* world, int steps) {
    for (int i = 0; i < steps; ++i) plumb::physics::step(*world, plumb::bench::kTick);
}

}  // namespace

namespace plumb::bench {

namespace {

using physics::Effect;
using physics::World;

/// Variants of a scene in which no body requires an effect: effect not added, added but unused, and added and
/// pinned on, which runs it nevertheless.
enum Variant { kAbsent, kUnused, kPinnedOn, kVariants };

World makeScene(Effect effect, int variant) {
    World world = physics::test::makeSceneWithout(effect);
    if (variant == kAbsent) world.manifest.pinnedOff |= physics::Manifest::bit(effect);
    if (variant == kPinnedOn) physics::test::pinEffectOn(world, effect);
    return world;
}

int printTable(CallgrindCounts& counted) {
    std::printf("%-16s%14s%14s%10s%14s%10s\n", "effect", "left out", "unused", "ratio", "pinned on", "ratio");
    int failed = 0;
    for (const Effect effect : physics::test::allEffects()) {
        double counts[kVariants];
        for (double& count : counts) count = counted.next();
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
    std::printf("\ninstructions of a step of %d crates, by callgrind\n", physics::test::kCrates);
    return countInstructions(program, "plumbCountedSteps", quick, printTable);
}

}  // namespace plumb::bench
