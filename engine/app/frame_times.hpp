#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace plumb {

/// Statistics of frame times by wall clock.
struct FrameTimes {
    std::size_t frames = 0;
    double meanMs = 0.0;
    double medianMs = 0.0;
    double slow95Ms = 0.0;  ///< ms, 95th percentile
    double slow99Ms = 0.0;  ///< ms, 99th percentile

    [[nodiscard]] double framesPerSecond() const { return meanMs > 0.0 ? 1000.0 / meanMs : 0.0; }
};

/// Computes the statistics. @param seconds  s, times of the frames in any order
FrameTimes frameTimesOf(std::span<const double> seconds);

/// Returns e.g. "Frame Rate: 145.2 FPS over 600 frames" and a line with median and percentiles.
std::string frameTimesText(const FrameTimes& times);

}  // namespace plumb
