#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/text.hpp"
#include "physics/islands/island_report.hpp"
#include "physics/simulation.hpp"
#include "tests/bench/bench.hpp"

// Benefit of an error tolerance: one hard island of bodies among 100 easy ones, with one quality for all
// and with a tolerance, which selects the quality of each island. Errors are the maximum of the last second.
//
// To count instructions, which do not depend on other work of the machine, one dump per row:
//     valgrind --tool=callgrind --zero-before="plumbCountedSteps*" --dump-after="plumbCountedSteps*"
//     and then: build/release/bin/plumb-bench quality counted tower

extern "C" __attribute__((noinline)) void plumbCountedSteps(plumb::physics::World* world, int steps) {
    for (int i = 0; i < steps; ++i) plumb::physics::step(*world, 1.0f / 60.0f);
}

namespace plumb::bench {

namespace {

using namespace physics;

constexpr float kTick = 1.0f / 60.0f;  // s
constexpr int kPiles = 100;
constexpr int kSettling = 480;  // steps until the islands are at rest
constexpr int kLooking = 60;    // steps in which errors are measured

struct Hard {
    const char* name;
    BodyId (*add)(World& world);  ///< @return the body that stays in place if the island holds
};

BodyId addCrate(World& world, WorldPosition at, float mass = 1.0f) {
    const auto body = createBody(world, {.position = at});
    static_cast<void>(createShape(world, *body, box({0.5f, 0.5f})));
    static_cast<void>(setMass(world, *body, mass));
    return *body;
}

BodyId addTower(World& world) {
    BodyId top;
    for (int i = 0; i < 20; ++i) top = addCrate(world, {-10.0, 0.5 + i});
    return top;
}

BodyId addHeavy(World& world) {
    addCrate(world, {-10.7, 0.5});
    addCrate(world, {-9.3, 0.5});
    const auto heavy = createBody(world, {.position = {-10.0, 2.0}});
    static_cast<void>(createShape(world, *heavy, box({1.0f, 1.0f})));
    static_cast<void>(setMass(world, *heavy, 1000.0f));
    return *heavy;
}

/// Adds bodies connected by hinges to a net; its loops cannot be solved as a tree of joints.
BodyId addNet(World& world) {
    constexpr int kSide = 8;
    std::vector<BodyId> knots;
    const BodyId ceiling = *createBody(world, {.kind = BodyKind::Static, .position = {-10.0, 20.0}});
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const BodyId knot = *createBody(world, {.position = {-10.0 + x, 20.0 - y}});
            static_cast<void>(createShape(world, knot, circle(0.2f), {.mask = 0}));
            const auto tie = [&](BodyId to, Vec2 anchor) {
                static_cast<void>(createJoint(
                    world,
                    {.kind = JointKind::Revolute, .a = to, .b = knot, .anchorA = anchor, .anchorB = {}}));
            };
            if (x > 0) tie(knots.back(), {1.0f, 0.0f});
            if (y > 0) tie(knots[knots.size() - kSide], {0.0f, -1.0f});
            if (y == 0 && (x == 0 || x == kSide - 1)) tie(ceiling, {static_cast<float>(x), 0.0f});
            knots.push_back(knot);
        }
    }
    return knots.back();
}

constexpr Hard kHard[] = {
    {"tower of 20", addTower}, {"1000 kg on two crates of 1", addHeavy}, {"net of 64", addNet}};

/// A world whose islands have come to rest, and its errors.
struct Row {
    std::string name;
    World world;
    float error = 0.0f;      // m
    std::uint64_t work = 0;  // per step: sum over islands of (bodies + contacts + joints) * substeps
    bool fell = false;       // the watched body did not stay in place

    Row(const Hard& hard, std::string what, Quality quality, float tolerance) : name{std::move(what)} {
        world.settings.gravity = {0.0f, -10.0f};
        world.settings.quality = quality;
        world.settings.tolerance = tolerance;
        world.settings.sleeping = false;
        const auto ground = createBody(world, {.kind = BodyKind::Static, .position = {0.0, -1.0}});
        static_cast<void>(createShape(world, *ground, box({2000.0f, 1.0f})));
        const BodyId watched = hard.add(world);
        const double height = centreOf(world, watched).y;
        for (int i = 0; i < kPiles; ++i) {
            for (int k = 0; k < 3; ++k) addCrate(world, {6.0 * i + 1.1 * k, 0.5});
            for (int k = 0; k < 2; ++k) addCrate(world, {6.0 * i + 0.55 + 1.1 * k, 1.5});
            addCrate(world, {6.0 * i + 1.1, 2.5});
        }
        for (int i = 0; i < kSettling; ++i) step(world, kTick);
        for (int i = 0; i < kLooking; ++i) {
            step(world, kTick);
            for (const IslandReport& island : reportIslands(world)) {
                error = std::max({error, island.overlap, island.jointError});
                work += std::uint64_t{island.bodies + island.contacts + island.joints} << island.quality;
            }
        }
        work /= kLooking;
        fell = std::fabs(centreOf(world, watched).y - height) > 1.0;
    }
};

std::vector<Row> makeRows(const Hard& hard) {
    std::vector<Row> rows;
    for (Quality quality = 0; quality <= kMaxQuality; ++quality)
        rows.emplace_back(hard, format("{} for all", 1 << quality), quality, 0.0f);
    for (const float mm : {20.0f, 10.0f, 5.0f, 2.0f, 1.0f, 0.5f})
        rows.emplace_back(hard, format("tolerance {} mm", fixedText(static_cast<double>(mm), 1)), Quality{2},
                          0.001f * mm);
    return rows;
}

/// Compares a tolerance with the cheapest uniform quality that is at least as accurate.
std::string gainOf(const std::vector<Row>& rows, const std::vector<double>& costs, std::size_t which) {
    std::size_t best = rows.size();
    for (std::size_t i = 0; i <= static_cast<std::size_t>(kMaxQuality); ++i) {
        if (!rows[i].fell && rows[i].error <= rows[which].error &&
            (best == rows.size() || costs[i] < costs[best]))
            best = i;
    }
    if (best == rows.size()) return "more accurate than any uniform quality";
    return format("{} times cheaper than {}", fixedText(costs[best] / costs[which], 2), rows[best].name);
}

void compare(const Hard& hard, const Options& options, std::vector<bench::Row>& results) {
    std::vector<Row> rows = makeRows(hard);
    std::vector<Contestant> contestants;
    for (Row& row : rows)
        contestants.push_back(
            {.prepare = {}, .run = [&world = row.world] { plumb::physics::step(world, kTick); }});
    const std::vector<Timing> timings = race(contestants, options);
    std::printf("\n%s among %d piles of 6\n%-18s %12s %12s %12s\n", hard.name, kPiles, "substeps", "error mm",
                "us/step", "work");
    std::vector<double> costs;
    for (const Timing& timing : timings) costs.push_back(timing.minimum * 1e6);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::printf("%-18s %12s %12s %12llu  %s\n", rows[i].name.c_str(),
                    fixedText(1000.0 * static_cast<double>(rows[i].error), 3).c_str(),
                    fixedText(costs[i], 1).c_str(), static_cast<unsigned long long>(rows[i].work),
                    rows[i].fell                              ? "fell"
                    : rows[i].world.settings.tolerance > 0.0f ? gainOf(rows, costs, i).c_str()
                                                              : "");
        results.push_back({.name = format("{}: {}", hard.name, rows[i].name),
                           .n = 1,
                           .ns = timings[i].minimum * 1e9,
                           .median = timings[i].median * 1e9});
    }
    std::fflush(stdout);
}

void count(const Hard& hard) {
    for (Row& row : makeRows(hard)) plumbCountedSteps(&row.world, 60);
}

}  // namespace

int runQuality(const Options& options) {
    const std::vector<std::string>& words = options.rest;
    const bool counted = !words.empty() && words.front() == "counted";
    const std::string part = words.size() > (counted ? 1u : 0u) ? words.back() : "";
    std::vector<bench::Row> results;
    for (const Hard& hard : kHard) {
        if (std::string_view{hard.name}.find(part) == std::string_view::npos) continue;
        counted ? count(hard) : compare(hard, options, results);
    }
    return options.jsonPath.empty() || writeRows(options.jsonPath, results) ? 0 : 1;
}

}  // namespace plumb::bench
