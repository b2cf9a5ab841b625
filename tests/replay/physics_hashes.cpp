// Prints a hash of the functions of math/portable.hpp, and the state hash of each golden scene. ./plumb test
// --compilers compares the output of builds with all compilers; ./plumb test --record writes the output to
// physics.golden. Every available instruction set, and multiple threads, must give the same hash of a scene;
// a different hash is printed on a line of its own.

#include <bit>
#include <cstdio>
#include <limits>

#include "core/cpu.hpp"
#include "core/hash.hpp"
#include "core/random.hpp"
#include "core/task_pool.hpp"
#include "math/portable.hpp"
#include "physics/simulation.hpp"
#include "tests/physics/support/golden_scenes.hpp"

namespace plumb {
namespace {

struct InstructionSet {
    SimdWidth width;
    const char* name;
};
constexpr InstructionSet kInstructionSets[] = {{SimdWidth::Avx2, " avx2"},
                                               {SimdWidth::Sse2, " sse2"},
                                               {SimdWidth::Neon, " neon"},
                                               {SimdWidth::Scalar, " scalar"}};

void print(const char* name, std::uint64_t hash, const char* with = "") {
    std::printf("%s %016llx%s\n", name, static_cast<unsigned long long>(hash), with);
}

void addFunctionsOf(Hasher& hasher, float x, float y) {
    const SinCos rotation = sinCos(x);
    for (const float value : {rotation.sin, rotation.cos, arcTangent(x, y), exponential(x)})
        hasher.add(value);
    hasher.add(static_cast<std::uint64_t>(floorToInt(x)));
}

std::uint64_t hashOfFunctions() {
    using Limits = std::numeric_limits<float>;
    constexpr float kEdges[] = {0.0f,
                                -0.0f,
                                1.0e-40f,
                                1.0f,
                                -1.0f,
                                87.9f,
                                -87.1f,
                                1.0e9f,
                                -3.0e30f,
                                Limits::max(),
                                Limits::min(),
                                kPi,
                                0.5f * -kTau,
                                Limits::quiet_NaN(),
                                Limits::infinity()};
    Hasher hasher;
    for (const float x : kEdges) {
        for (const float y : kEdges) addFunctionsOf(hasher, x, y);
    }
    Random random = Random::seeded(1);
    for (int i = 0; i < 200'000; ++i) {
        const float near = random.between(-10.0f, 10.0f), wide = random.between(-1.0e5f, 1.0e5f);
        addFunctionsOf(hasher, near, wide);
        addFunctionsOf(hasher, wide, near);
        addFunctionsOf(hasher, std::bit_cast<float>(random.next()), near);  // any bit pattern, including NaN
    }
    return hasher.value();
}

std::uint64_t hashAfterAll(const physics::test::GoldenScene& scene, TaskPool* pool = nullptr) {
    physics::World world = scene.build();
    for (int i = 0; i < scene.steps; ++i) {
        if (scene.before != nullptr) scene.before(world, i);
        step(world, 1.0f / 60.0f, {.pool = pool, .minimumWork = 0});
    }
    return hashOf(world);
}

/// Prints the hash of a scene. @return true if all instruction sets and multiple threads give the same hash
bool printScene(const physics::test::GoldenScene& scene, TaskPool& pool) {
    const SimdWidth widest = simdWidth();
    const std::uint64_t hash = hashAfterAll(scene);
    print(scene.name, hash);
    bool alike = true;
    const auto compare = [&](std::uint64_t other, const char* with) {
        if (other == hash) return;
        print(scene.name, other, with);
        alike = false;
    };
    compare(hashAfterAll(scene, &pool), " three threads");
    for (const InstructionSet& set : kInstructionSets) {
        if (set.width != widest && setSimdWidth(set.width)) compare(hashAfterAll(scene), set.name);
    }
    setSimdWidth(widest);
    return alike;
}

}  // namespace
}  // namespace plumb

int main() {
    using namespace plumb;
    print("functions", hashOfFunctions());
    TaskPool pool{3};
    bool alike = true;
    for (const physics::test::GoldenScene& scene : physics::test::goldenScenes())
        alike = printScene(scene, pool) && alike;
    std::fprintf(stderr, "instructions:");
    for (const InstructionSet& set : kInstructionSets)
        if (hasSimdWidth(set.width)) std::fprintf(stderr, "%s", set.name);
    std::fprintf(stderr, "\n");
    return alike ? 0 : 1;
}
