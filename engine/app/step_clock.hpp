#pragma once

namespace plumb {

/// Converts variable frame times to whole ticks of 1/60 s and a remainder for interpolation, so that the
/// simulation does not depend on the frame rate. Source: G. Fiedler, "Fix Your Timestep!", 2004.
class StepClock {
public:
    static constexpr double kStep = 1.0 / 60.0;    ///< s, length of a tick
    static constexpr double kLongestFrame = 0.25;  ///< s; longer frames are cut to this, not caught up
    static constexpr int kMostTicks = 15;  ///< maximum number of ticks per frame; slow machines run slower

    struct Frame {
        int ticks = 0;       ///< number of ticks to simulate now
        float alpha = 0.0f;  ///< ratio between the last two ticks at which to draw, 0..1
    };

    /// @param seconds  s since the previous frame; negative values and NaN count as 0
    Frame advance(double seconds);

private:
    double remainder_ = 0.0;  // s not yet simulated, 0..kStep
};

/// Rounds a frame time to a multiple of the period of a display with `rate` Hz if it is close to one.
/// Measured times jitter by fractions of a millisecond, which would make motion jitter too.
double snappedToRefresh(double seconds, double rate);

}  // namespace plumb
