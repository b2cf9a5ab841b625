#include "app/frame_times.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/text.hpp"

namespace plumb {
namespace {

/// Returns the smallest value that a ratio `part` of all values does not exceed. @pre sorted, not empty
double percentile(std::span<const double> sorted, double part) {
    const double place = std::ceil(part * static_cast<double>(sorted.size())) - 1.0;
    return sorted[static_cast<std::size_t>(std::max(place, 0.0))];
}

}  // namespace

FrameTimes frameTimesOf(std::span<const double> seconds) {
    FrameTimes times;
    if (seconds.empty()) return times;
    std::vector<double> sorted(seconds.begin(), seconds.end());
    std::sort(sorted.begin(), sorted.end());
    times.frames = sorted.size();
    times.meanMs =
        1000.0 * std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
    times.medianMs = 1000.0 * percentile(sorted, 0.5);
    times.slow95Ms = 1000.0 * percentile(sorted, 0.95);
    times.slow99Ms = 1000.0 * percentile(sorted, 0.99);
    return times;
}

std::string frameTimesText(const FrameTimes& times) {
    return format("Frame Rate: {} FPS over {} frames\n", fixedText(times.framesPerSecond(), 1),
                  times.frames) +
           format("Frame Time: {}ms median, {}ms 95%, {}ms 99%\n", fixedText(times.medianMs, 2),
                  fixedText(times.slow95Ms, 2), fixedText(times.slow99Ms, 2));
}

}  // namespace plumb
