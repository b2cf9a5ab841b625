#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::bench {

/// What the command line asks for.
struct Options {
    std::string jsonPath;  ///< empty: no file
    bool quick = false;    ///< small sizes and few rounds: does it run at all?
    double seconds = 0.4;  ///< for each contestant of a race
    std::vector<std::string> rest;
};

/// One side of a comparison.
struct Contestant {
    std::function<void()> prepare;  ///< before each run, not timed; may be empty
    std::function<void()> run;
};

/// Seconds of one run.
struct Timing {
    double minimum = 0.0;
    double median = 0.0;
};

/// Runs the contestants in turn, so that whatever else the machine does meets them all alike.
/// Only compare what ran in the same race: two races differ by half.
std::vector<Timing> race(std::span<const Contestant> contestants, const Options& options);

/// Makes the compiler believe that memory is read and written here. Takes an address, never a value:
/// handing floats to such a barrier has been seen to change them.
inline void keep(const void* address) {
#if defined(__GNUC__)
    asm volatile("" : : "r"(address) : "memory");
#else
    static const volatile void* sink;
    sink = address;
#endif
}

/// One result.
struct Row {
    std::string name;
    std::size_t n = 0;
    double ns = 0.0;       ///< per item, the best round
    double median = 0.0;   ///< ns per item
    double limitNs = 0.0;  ///< plain arrays doing the same in the same race; 0 where there is no such thing
    double target = 0.0;   ///< ns per item on this machine; 0 for none
    [[nodiscard]] bool met() const { return target == 0.0 || ns <= target; }
};

void printHeader();
void print(const Row& row);
/// Writes the rows as JSON: {name, n, ns, median, limitNs, target, met}. @return false when it could not
bool writeRows(const std::string& path, std::span<const Row> rows);

// The programs of plumb-bench: one file each, one line in main.cpp each. They give back an exit code.

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
int runTiles(const Options& options);

}  // namespace plumb::bench
