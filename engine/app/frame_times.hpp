#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace plumb {

/// What a row of frames took by the clock on the wall: what a player sees.
struct FrameTimes {
    std::size_t frames = 0;
    double meanMs = 0.0;
    double medianMs = 0.0;
    double slow95Ms = 0.0;  ///< 95 % of the frames took no longer
    double slow99Ms = 0.0;

    [[nodiscard]] double framesPerSecond() const { return meanMs > 0.0 ? 1000.0 / meanMs : 0.0; }
};

/// @param seconds  of each frame, in any order
FrameTimes frameTimesOf(std::span<const double> seconds);

/// "Frame Rate: 145.2 FPS over 600 frames" and a line with the three times.
std::string frameTimesText(const FrameTimes& times);

}  // namespace plumb
