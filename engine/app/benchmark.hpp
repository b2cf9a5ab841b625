#pragma once

#include "app/frame_times.hpp"
#include "app/screen.hpp"

namespace plumb {

/// How many entities are measured, and for how long.
struct BenchmarkSettings {
    int entities = 10'000;
    int frames = 120;  ///< after a warm-up; one tick each
};

/// What a frame of moving, colliding, drawn entities costs this machine.
struct BenchmarkResult {
    int entities = 0;
    double systemsMs = 0.0;  ///< all systems without the two phases below
    double broadMs = 0.0;
    double narrowMs = 0.0;
    double renderMs = 0.0;
    std::size_t drawCalls = 0;
    std::size_t contacts = 0;  ///< that began while measuring
    PixelSize window;          ///< px; nothing when nothing was drawn
    FrameTimes frameTimes;     ///< of the window, by the clock on the wall

    [[nodiscard]] double totalMs() const { return systemsMs + broadMs + narrowMs + renderMs; }
};

/// Medians of CPU time over the frames, and what the frames took by the clock.
/// @param screen  null leaves rendering out
BenchmarkResult runBenchmark(const BenchmarkSettings& settings, Screen* screen);

/// The table as the seed shows it; below it what else was counted.
std::string benchmarkTable(const BenchmarkResult& result);

}  // namespace plumb
