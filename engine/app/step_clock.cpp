#include "app/step_clock.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {

StepClock::Frame StepClock::advance(double seconds) {
    if (!(seconds > 0.0)) seconds = 0.0;
    remainder_ += std::min(seconds, kLongestFrame);
    // Tolerance for rounding: 60 frames of exactly 1/60 s must be 60 ticks.
    constexpr double kHair = 1.0e-9;
    int ticks = static_cast<int>((remainder_ + kHair) / kStep);
    remainder_ = std::max(0.0, remainder_ - ticks * kStep);
    ticks = std::min(ticks, kMostTicks);
    return {ticks, static_cast<float>(std::min(remainder_ / kStep, 1.0))};
}

double snappedToRefresh(double seconds, double rate) {
    if (!(rate >= 20.0) || !(rate <= 1000.0)) return seconds;
    const double period = 1.0 / rate;
    const double periods = std::floor(seconds / period + 0.5);
    const double snapped = periods * period;
    return periods >= 1.0 && periods <= 8.0 && std::fabs(seconds - snapped) < 0.12 * period ? snapped
                                                                                            : seconds;
}

}  // namespace plumb
