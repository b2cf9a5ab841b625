// Compares the speed of the broad phases for several distributions and numbers of bodies.

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

#include "core/clock.hpp"
#include "core/text.hpp"
#include "tests/bench/bench.hpp"
#include "tests/bench/physics/crowd.hpp"
#include "tests/bench/physics/plumb_world.hpp"
#include "tests/bench/physics/progress.hpp"
#include "tests/bench/physics/report.hpp"

namespace plumb::bench {
namespace {

using physics::BroadPhase;
using physics::BroadPhaseKind;
using physics::PairKey;
using scenes::Measurement;

constexpr auto kKinds = static_cast<std::size_t>(BroadPhaseKind::Count);
constexpr double kTarget = 1.15;  // maximum exponent p of cost ~ n^p
constexpr double kMicroseconds = 1e6;
constexpr double kNanoseconds = 1e9;
constexpr std::uint32_t kCrowd = 10000;
constexpr int kSteps = 60;

using Costs = std::array<double, kKinds>;  // s per step, by kind

std::string_view nameOf(std::size_t kind) { return physics::nameOf(static_cast<BroadPhaseKind>(kind)); }

/// A broad phase and its minimum time of each step over all rounds.
struct Runner {
    std::unique_ptr<BroadPhase> phase;
    std::vector<double> best;  ///< s
    std::vector<std::uint32_t> moved;
    std::vector<PairKey> pairs;

    /// Calls the broad phase as a step of the simulation does, and measures its time.
    void run(const scenes::Crowd& crowd, std::size_t step) {
        moved.assign(crowd.moved().begin(), crowd.moved().end());
        pairs.clear();
        const double start = wallSeconds();
        phase->update(crowd.proxies(), crowd.changed());
        phase->arrange(moved);
        phase->findPairs(moved, crowd.isMoved(), pairs);
        const double seconds = wallSeconds() - start;
        best[step] = std::min(best[step], seconds);
    }
};

class Race {
public:
    Race(const scenes::CrowdKind& kind, std::uint32_t boxes, int rounds) {
        for (Runner& runner : runners_) runner.best.assign(kSteps, 1.0);
        for (int round = 0; round < rounds; ++round) {
            showProgress(format("{}, {} boxes, round {} of {}", kind.name, boxes, round + 1, rounds));
            runRound(kind.make(boxes));
        }
        showProgress("");
    }
    /// Returns the mean over all steps of their minimum times.
    [[nodiscard]] Costs costs() const {
        return ofEach(
            [](const auto& best) { return std::accumulate(best.begin(), best.end(), 0.0) / kSteps; });
    }
    /// Returns the maximum over all steps of their minimum times: the delay that a player notices if a broad
    /// phase reorganizes its data only in some steps.
    [[nodiscard]] Costs longest() const {
        return ofEach([](const auto& best) { return *std::max_element(best.begin(), best.end()); });
    }
    [[nodiscard]] bool agrees() const { return agrees_; }
    [[nodiscard]] std::size_t pairs() const { return pairs_; }

private:
    template <class Of>
    [[nodiscard]] Costs ofEach(const Of& of) const {
        Costs costs{};
        for (std::size_t i = 0; i < kKinds; ++i) costs[i] = of(runners_[i].best);
        return costs;
    }

    void runRound(scenes::Crowd crowd) {
        for (std::size_t i = 0; i < kKinds; ++i) {
            runners_[i].phase = physics::makeBroadPhase(static_cast<BroadPhaseKind>(i));
            runners_[i].phase->rebuild(crowd.proxies());
        }
        for (std::size_t step = 0; step < kSteps; ++step) {
            crowd.step();
            for (std::size_t i = 0; i < kKinds; ++i) runners_[(i + step) % kKinds].run(crowd, step);
            for (Runner& runner : runners_) std::sort(runner.pairs.begin(), runner.pairs.end());
            for (const Runner& runner : runners_) agrees_ = agrees_ && runner.pairs == runners_.front().pairs;
            pairs_ += runners_.front().pairs.size();
        }
    }

    std::array<Runner, kKinds> runners_;
    bool agrees_ = true;
    std::size_t pairs_ = 0;
};

void printKinds(const char* title) {
    std::printf("%-26s", title);
    for (std::size_t i = 0; i < kKinds; ++i)
        std::printf(" %15.*s ", static_cast<int>(nameOf(i).size()), nameOf(i).data());
    std::printf("\n");
}

/// Prints a row of costs and marks the smallest with '*'.
void printCosts(const std::string& name, const Costs& costs) {
    std::printf("%-26s", name.c_str());
    const double minimum = *std::min_element(costs.begin(), costs.end());
    for (const double cost : costs) {
        const double us = cost * kMicroseconds;
        std::printf(" %15s%c", fixedText(us, us < 100.0 ? 2 : 0).c_str(), cost == minimum ? '*' : ' ');
    }
    std::printf("\n");
    std::fflush(stdout);
}

/// Collects all results for the JSON file and the exit code.
class Results {
public:
    void add(std::string_view line, std::uint32_t boxes, const Costs& costs) {
        for (std::size_t i = 0; i < kKinds; ++i)
            rows_.push_back({.name = format("{}: {}", line, nameOf(i)),
                             .n = boxes,
                             .ns = costs[i] * kNanoseconds / boxes});
    }
    void add(std::string_view line, const Measurement& row, double broadMs) {
        const double perBody = 1e6 / row.size;
        rows_.push_back({.name = format("{}: step", line),
                         .n = static_cast<std::size_t>(row.size),
                         .ns = row.quietMs * perBody});
        rows_.push_back({.name = format("{}: broad phase", line),
                         .n = static_cast<std::size_t>(row.size),
                         .ns = broadMs * perBody});
    }
    void noteAgreement(const Race& race) { agrees_ = agrees_ && race.agrees() && race.pairs() > 0; }
    void noteExponent(double exponent) { meets_ = meets_ && exponent <= kTarget; }

    [[nodiscard]] int finish(const Options& options) const {
        if (!agrees_) std::printf("BROKEN: the broad phases found different pairs, or none\n");
        if (!meets_)
            std::printf("MISSED: the default's cost grows with an exponent above %s\n",
                        fixedText(kTarget, 2).c_str());
        if (!options.jsonPath.empty() && !writeRows(options.jsonPath, rows_)) return 1;
        return agrees_ ? 0 : 1;
    }

private:
    std::vector<Row> rows_;
    bool agrees_ = true;
    bool meets_ = true;
};

bool wants(const Options& options, std::string_view name) {
    return options.rest.empty() ||
           std::any_of(options.rest.begin(), options.rest.end(),
                       [&](const auto& part) { return name.find(part) != std::string_view::npos; });
}

void raceCrowds(const Options& options, Results& results) {
    const std::uint32_t boxes = options.quick ? kCrowd / 10 : kCrowd;
    std::vector<std::pair<std::string, Costs>> longest;
    for (const scenes::CrowdKind& kind : scenes::crowdKinds()) {
        if (!wants(options, kind.name)) continue;
        if (longest.empty()) printKinds(format("us a step, {} boxes", boxes).c_str());
        const Race race{kind, boxes, options.quick ? 2 : 12};
        printCosts(std::string{kind.name}, race.costs());
        results.add(kind.name, boxes, race.costs());
        results.noteAgreement(race);
        longest.emplace_back(kind.name, race.longest());
    }
    if (!longest.empty()) std::printf("\n");
    if (!longest.empty()) printKinds("us of the longest step");
    for (const auto& [name, costs] : longest) printCosts(name, costs);
}

/// Measures how the cost of the broad phases alone grows with the number of boxes.
void raceSizes(const scenes::CrowdKind& kind, const Options& options, Results& results) {
    if (!wants(options, kind.name)) return;
    std::printf("\n");
    printKinds(format("us a step, {}", kind.name).c_str());
    std::array<std::vector<Measurement>, kKinds> lines;
    for (const std::uint32_t boxes : {10u, 100u, 1000u, 10000u, 100000u}) {
        if (options.quick && boxes > 1000) break;
        const Race race{kind, boxes, options.quick ? 2 : boxes > 10000 ? 3 : boxes > 1000 ? 10 : 60};
        const Costs costs = race.costs();
        printCosts(format("{} boxes", boxes), costs);
        results.add(format("{} by number", kind.name), boxes, costs);
        results.noteAgreement(race);
        for (std::size_t i = 0; i < kKinds; ++i)
            lines[i].push_back({.size = static_cast<int>(boxes), .quietMs = costs[i] * 1e3});
    }
    std::printf("%-26s", "grows as n^");
    for (const auto& line : lines) std::printf(" %15s ", fixedText(scenes::exponentOf(line), 2).c_str());
    std::printf("\n");
    results.noteExponent(scenes::exponentOf(lines.front()));
}

double broadPhaseMs(const Measurement& row) {
    for (const Profile::Zone& zone : row.stages) {
        if (zone.name == "broad phase") return zone.seconds;  // measure() has converted it to ms per step
    }
    return 0.0;
}

/// Measures how the cost of complete steps, and of the default broad phase in them, grows with the number of
/// bodies.
void measureFalls(const std::string& family, const Options& options, Results& results) {
    if (!wants(options, family)) return;
    const scenes::Engine engine = scenes::plumbEngine();
    const scenes::Contender contender{&engine, 1};
    std::printf("\n%-26s %15s %15s\n", family.c_str(), "us/step", "broad phase");
    std::vector<Measurement> steps, broad;
    for (const int size : {10, 100, 1000, 10000, 100000}) {
        if (options.quick && size > 1000) break;
        const scenes::Scene* scene = scenes::findScene(format("{}_{}", family, size));
        const auto rows = scenes::measure(*scene, {&contender, 1}, {.runs = size > 10000 ? 1 : 4});
        steps.push_back(rows.front());
        broad.push_back(rows.front());
        broad.back().quietMs = broadPhaseMs(rows.front());
        std::printf("%-26s %15s %15s\n", format("{} bodies", size).c_str(),
                    fixedText(steps.back().quietMs * 1e3, 1).c_str(),
                    fixedText(broad.back().quietMs * 1e3, 2).c_str());
        std::fflush(stdout);
        results.add(family, steps.back(), broad.back().quietMs);
    }
    std::printf("%-26s %15s %15s\n", "grows as n^", fixedText(scenes::exponentOf(steps), 2).c_str(),
                fixedText(scenes::exponentOf(broad), 2).c_str());
    results.noteExponent(scenes::exponentOf(steps));
    results.noteExponent(scenes::exponentOf(broad));
}

}  // namespace

int runBroadphase(const Options& options) {
    Results results;
    raceCrowds(options, results);
    for (const scenes::CrowdKind& kind : scenes::crowdKinds().first(2)) raceSizes(kind, options, results);
    for (const char* family : {"boxes_uniform", "boxes_clustered", "circles_uniform", "circles_clustered"})
        measureFalls(family, options, results);
    return results.finish(options);
}

}  // namespace plumb::bench
