#pragma once

#include "app/frame_times.hpp"
#include "app/screen.hpp"

namespace plumb {

/// Size and length of a benchmark run.
struct BenchmarkSettings {
    int entities = 10'000;  ///< number of simulated and drawn entities
    int frames = 120;       ///< number of measured frames after the warm-up, one tick each
};

/// Times of a frame with moving, colliding, drawn entities on this machine.
struct BenchmarkResult {
    int entities = 0;
    double systemsMs = 0.0;     ///< ms, all systems except the two phases below
    double broadMs = 0.0;       ///< ms, broad phase of collision detection
    double narrowMs = 0.0;      ///< ms, narrow phase of collision detection
    double renderMs = 0.0;      ///< ms, drawing
    std::size_t drawCalls = 0;  ///< number of draw calls of the last frame
    std::size_t contacts = 0;   ///< number of contacts that began in the measured frames
    PixelSize window;           ///< px; empty if nothing was drawn
    FrameTimes frameTimes;      ///< times of whole frames, by wall clock

    [[nodiscard]] double totalMs() const { return systemsMs + broadMs + narrowMs + renderMs; }
};

/// Runs the benchmark. Stage times are medians of CPU time over the frames.
/// @param screen  null: do not render
BenchmarkResult runBenchmark(const BenchmarkSettings& settings, Screen* screen);

/// Returns the result as text: the table of times, then counters and frame times.
std::string benchmarkTable(const BenchmarkResult& result);

}  // namespace plumb
