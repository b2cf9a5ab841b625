#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/text.hpp"
#include "math/portable.hpp"
#include "physics/model/fields.hpp"
#include "physics/simulation.hpp"
#include "tests/bench/bench.hpp"

// Cost per body of the integrators for smooth forces, and their accuracy: the maximum relative energy error
// of a spring in 10 s.

namespace plumb::bench {

namespace {

using namespace physics;

constexpr float kTick = 1.0f / 60.0f;
constexpr int kBodies = 1000;

struct Kind {
    const char* name;
    IntegratorKind kind;
};
constexpr Kind kKinds[] = {{"explicit Euler", IntegratorKind::ExplicitEuler},
                           {"semi-implicit Euler", IntegratorKind::SemiImplicitEuler},
                           {"Verlet", IntegratorKind::Verlet},
                           {"Runge-Kutta 4", IntegratorKind::Rk4}};

World makeWorld(IntegratorKind kind, Quality quality) {
    World world;
    world.settings.gravity = {};
    world.settings.integrator = kind;
    world.settings.quality = quality;
    world.settings.sleeping = false;
    return world;
}

/// Returns a world of bodies that are pulled by one attractor and do not collide.
World makeSwarm(IntegratorKind kind, Quality quality) {
    World world = makeWorld(kind, quality);
    for (int i = 0; i < kBodies; ++i) {
        const SinCos at = sinCos(kTau * static_cast<float>(i) / kBodies);
        const float reach = 50.0f + 0.05f * static_cast<float>(i);
        const auto body = createBody(world, {.position = {Vec2{reach * at.cos, reach * at.sin}}});
        if (body) static_cast<void>(createShape(world, *body, circle(0.1f), {.mask = 0}));
    }
    static_cast<void>(
        createField(world, {.kind = FieldKind::Attractor, .strength = 1000.0f, .length = 1.0f}));
    return world;
}

double springError(IntegratorKind kind, Quality quality, float hertz) {
    World world = makeWorld(kind, quality);
    const float omega = kTau * hertz;
    const auto body = createBody(world, {.position = {1.0, 0.0}});
    static_cast<void>(createShape(world, *body, circle(0.1f)));
    static_cast<void>(setMass(world, *body, 1.0f));
    static_cast<void>(createField(world, {.kind = FieldKind::Spring, .strength = omega * omega, .a = *body}));
    double worst = 0.0;
    for (int i = 0; i < 600; ++i) {
        step(world, kTick);
        const double x = positionOf(world, *body).x;
        const double v = static_cast<double>(velocityOf(world, *body).x) / static_cast<double>(omega);
        worst = std::max(worst, std::fabs(x * x + v * v - 1.0));
    }
    return worst;
}

}  // namespace

int runIntegrators(const Options& options) {
    std::printf("%-20s %8s %10s %12s %12s %12s\n", "integrator", "substeps", "ns/body", "0.5 Hz", "2 Hz",
                "10 Hz");
    std::vector<Row> rows;
    for (const Quality quality : {Quality{0}, Quality{2}, Quality{4}}) {
        std::array<World, std::size(kKinds)> worlds;
        std::array<Contestant, std::size(kKinds)> contestants;
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            worlds[i] = makeSwarm(kKinds[i].kind, quality);
            contestants[i].run = [&world = worlds[i]] { step(world, kTick); };
        }
        const std::vector<Timing> timings = race(contestants, options);
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            const double ns = timings[i].median * 1.0e9 / kBodies;
            std::printf("%-20s %8d %10.1f", kKinds[i].name, 1 << quality, ns);
            for (const float hertz : {0.5f, 2.0f, 10.0f})
                std::printf(" %12.3g", springError(kKinds[i].kind, quality, hertz));
            std::printf("\n");
            std::fflush(stdout);
            rows.push_back({.name = format("{} {}", kKinds[i].name, 1 << quality),
                            .n = kBodies,
                            .ns = ns,
                            .median = ns});
        }
    }
    return options.jsonPath.empty() || writeRows(options.jsonPath, rows) ? 0 : 1;
}

}  // namespace plumb::bench
