#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::bench {

/// Options of the command line.
struct Options {
    std::string jsonPath;           ///< empty: no file
    bool quick = false;             ///< small sizes and few rounds, only to check that the benchmark runs
    double seconds = 0.4;           ///< measuring time for each contestant of a race
    std::vector<std::string> rest;  ///< further arguments
};

/// One of the alternatives compared in a race.
struct Contestant {
    std::function<void()> prepare;  ///< called before each run, not timed; may be empty
    std::function<void()> run;
};

/// Time of one run, s.
struct Timing {
    double minimum = 0.0;
    double median = 0.0;
};

/// Runs the contestants alternately, so that other work of the machine affects all equally.
/// Compare only timings of the same race, because those of two races can differ by half.
std::vector<Timing> race(std::span<const Contestant> contestants, const Options& options);

/// Compiler barrier: prevents that computations with the memory at `address` are optimized away. Takes an
/// address instead of a value, because passing a float to such a barrier can change its value.
inline void keep(const void* address) {
#if defined(__GNUC__)
    asm volatile("" : : "r"(address) : "memory");
#else
    static const volatile void* sink;
    sink = address;
#endif
}

/// One result of a benchmark.
struct Row {
    std::string name;
    std::size_t n = 0;
    double ns = 0.0;       ///< ns per item, minimum of all rounds
    double median = 0.0;   ///< ns per item, median of all rounds
    double limitNs = 0.0;  ///< ns per item with plain arrays, in the same race; 0: not measured
    double target = 0.0;   ///< maximum ns per item on this machine; 0: no target
    [[nodiscard]] bool met() const { return target == 0.0 || ns <= target; }
};

void printHeader();
void print(const Row& row);
/// Writes the rows as JSON: {name, n, ns, median, limitNs, target, met}. @return false if that failed
bool writeRows(const std::string& path, std::span<const Row> rows);

// The benchmarks of plumb-bench: each has one file and one line in main.cpp, and returns an exit code.

int runBroadphase(const Options& options);
int runEcs(const Options& options);
int runEditor(const Options& options);
int runIntegrators(const Options& options);
int runParticles(const Options& options);
int runPhysics(const Options& options);
int runQuality(const Options& options);
int runRender(const Options& options);
int runRewind(const Options& options);
int runScene(const Options& options);
int runScripts(const Options& options);
int runTiles(const Options& options);

}  // namespace plumb::bench
