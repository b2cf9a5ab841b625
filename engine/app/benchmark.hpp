#pragma once

#include "app/screen.hpp"

namespace plumb {

/// What a frame of 10,000 moving, colliding, drawn entities costs this machine.
struct BenchmarkResult {
    int entities = 0;
    double systemsMs = 0.0;  ///< all systems without the two phases below
    double broadMs = 0.0;
    double narrowMs = 0.0;
    double renderMs = 0.0;
    std::size_t drawCalls = 0;
    std::size_t contacts = 0;  ///< that began while measuring

    [[nodiscard]] double totalMs() const { return systemsMs + broadMs + narrowMs + renderMs; }
};

/// Medians of CPU time over `ticks` ticks after a warm-up. @param screen  null leaves rendering out
BenchmarkResult runBenchmark(int entities, int ticks, Screen* screen);

/// The table as the seed shows it.
std::string benchmarkTable(const BenchmarkResult& result);

}  // namespace plumb
