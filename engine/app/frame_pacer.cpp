#include "app/frame_pacer.hpp"

#include <algorithm>
#include <utility>

namespace plumb {

StepClock::Frame FramePacer::next(double seconds) {
    if (paused_) return {0, alpha_};
    const bool wasPaused = std::exchange(resumes_, false);
    if (seconds > 0.0 && !wasPaused) remainder_ += seconds;
    const double given = std::max(snappedToRefresh(remainder_, refreshRate_), 0.0);
    remainder_ -= given;
    const StepClock::Frame frame = clock_.advance(given);
    alpha_ = frame.alpha;
    return frame;
}

double FramePacer::rest(double seconds) const {
    double rate = refreshRate_ >= 20.0 && refreshRate_ <= 1000.0 ? 2.0 * refreshRate_ : kUnknownRate;
    if (cap_ > 0.0) rate = cap_;
    return std::clamp(1.0 / rate - seconds, 0.0, 1.0 / rate);
}

}  // namespace plumb
