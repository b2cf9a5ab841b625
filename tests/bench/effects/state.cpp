#include <cstdio>

#include "physics/simulation.hpp"
#include "tests/bench/bench.hpp"
#include "tests/bench/effects/effects_bench.hpp"

namespace plumb::bench {

namespace {

using namespace physics;

constexpr int kBodies = 1000;

/// Returns a world of 1000 crates in rows and stacks, awake and in contact.
World makeRows() {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    world.settings.sleeping = false;
    const BodyId ground = *createBody(world, {.kind = BodyKind::Static, .position = {0.0, -1.0}});
    static_cast<void>(createShape(world, ground, box({200.0f, 1.0f})));
    for (int i = 0; i < kBodies; ++i) {
        BodyDefinition body;
        body.position = {-55.0 + 1.1 * (i % 100), 0.5 + i / 100};
        static_cast<void>(createShape(world, *createBody(world, body), box({0.5f, 0.5f})));
    }
    for (int i = 0; i < 60; ++i) step(world, kTick);
    return world;
}

}  // namespace

int measureState(bool quick) {
    const int rounds = quick ? 3 : 400;
    World world = makeRows();
    World saved = world;
    std::uint64_t hash = 0;
    const double save = quickest(rounds, [&] { saved = world; });
    const double restore = quickest(rounds, [&] { world = saved; });
    const double hashing = quickest(rounds, [&] { hash ^= hashOf(world), keep(&hash); });
    const std::size_t bytes = stateBytes(world), contacts = world.contacts.size() * sizeof(Contact);
    std::printf("\n%d awake boxes, %zu contacts\n", kBodies, world.contacts.size());
    std::printf("%-38s%12.4f ms (target 0.05)\n%-38s%12.4f ms (target 0.05)\n%-38s%12.4f ms (target 0.03)\n",
                "snapshot into a world", 1e-6 * save, "restore", 1e-6 * restore, "hash", 1e-6 * hashing);
    std::printf("%-38s%12.1f bytes (target 256), and %.1f of contacts\n", "state per body with one box",
                static_cast<double>(bytes - contacts) / kBodies, static_cast<double>(contacts) / kBodies);
    return 0;
}

}  // namespace plumb::bench
