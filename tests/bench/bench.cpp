#include "tests/bench/bench.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/clock.hpp"
#include "core/file.hpp"
#include "core/text.hpp"

namespace plumb::bench {

namespace {

constexpr double kShortestSample = 100e-6;  // s; shorter samples are affected by the resolution of the clock
constexpr std::size_t kMinRounds = 15;
constexpr std::size_t kMinLongRounds = 3;
constexpr std::size_t kMaxRounds = 1000000;
constexpr double kPatience = 3.0;  // s per contestant; slower ones get only kMinLongRounds rounds

/// Returns the time to read the clock, s.
double clockCost() {
    static const double cost = [] {
        double best = 1.0;
        for (int i = 0; i < 1000; ++i) {
            const double start = wallSeconds();
            best = std::min(best, wallSeconds() - start);
        }
        return best;
    }();
    return cost;
}

/// A contestant and its samples.
struct Lane {
    explicit Lane(const Contestant& one) : contestant{one} { calibrate(); }

    /// Returns the time of one run, s. Uses the wall clock: interruptions only make
    /// a run longer, so it is not the minimum. The clock of the thread subtracts
    /// estimated interruptions and sometimes subtracts too much.
    double sample() {
        if (contestant.prepare) contestant.prepare();
        const double start = wallSeconds();
        for (int i = 0; i < repeats; ++i) contestant.run();
        const double seconds = wallSeconds() - start - clockCost();
        return std::max(seconds, 0.0) / repeats;
    }
    /// Sets `repeats` so that a sample is long compared to the resolution of the clock. Runs that need a
    /// preparation are not repeated.
    void calibrate() {
        const double first = sample();
        if (contestant.prepare || first > kShortestSample) return;
        const double once = std::max(sample(), 1e-9);
        repeats = static_cast<int>(std::clamp(std::ceil(kShortestSample / once), 1.0, 1e6));
    }

    const Contestant& contestant;
    int repeats = 1;
    std::vector<double> samples;
};

}  // namespace

std::vector<Timing> race(std::span<const Contestant> contestants, const Options& options) {
    std::vector<Lane> lanes(contestants.begin(), contestants.end());
    const double budget = (options.quick ? 0.02 : options.seconds) * static_cast<double>(lanes.size());  // s
    const double patience = kPatience * static_cast<double>(lanes.size());
    const std::size_t fewest = options.quick ? kMinLongRounds : kMinRounds;
    const double start = wallSeconds();
    for (std::size_t round = 0; round < kMaxRounds; ++round) {
        const double spent = wallSeconds() - start;
        if (round >= fewest && spent > budget) break;
        if (round >= kMinLongRounds && spent > patience) break;
        for (Lane& lane : lanes) lane.samples.push_back(lane.sample());
    }
    std::vector<Timing> timings;
    for (Lane& lane : lanes) {
        std::sort(lane.samples.begin(), lane.samples.end());
        timings.push_back({lane.samples.front(), lane.samples[lane.samples.size() / 2]});
    }
    return timings;
}

void printHeader() {
    std::printf("%-34s %8s %10s %10s %10s %7s %10s\n", "", "n", "ns", "median", "limit", "ratio", "target");
}

void print(const Row& row) {
    const auto number = [](double value) { return value == 0.0 ? std::string{"-"} : fixedText(value, 3); };
    std::printf("%-34s %8zu %10s %10s %10s %7s %10s  %s\n", row.name.c_str(), row.n, number(row.ns).c_str(),
                number(row.median).c_str(), number(row.limitNs).c_str(),
                row.limitNs > 0.0 ? fixedText(row.ns / row.limitNs, 2).c_str() : "-",
                number(row.target).c_str(),
                row.target == 0.0 ? ""
                : row.met()       ? "met"
                                  : "MISSED");
    std::fflush(stdout);
}

bool writeRows(const std::string& path, std::span<const Row> rows) {
    std::string text = "[\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        text += format(
            "  {\"name\": \"{}\", \"n\": {}, \"ns\": {}, \"median\": {}, \"limitNs\": {}, \"target\": {}, "
            "\"met\": {}}{}\n",
            row.name, row.n, row.ns, row.median, row.limitNs, row.target, row.met(),
            i + 1 < rows.size() ? "," : "");
    }
    const auto written = writeFile(path, text + "]\n");
    if (!written) std::fprintf(stderr, "%s\n", written.error().text().c_str());
    return written.ok();
}

}  // namespace plumb::bench
