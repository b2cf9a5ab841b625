#pragma once

namespace plumb {

/// Turns the uneven time between frames into whole ticks of 1/60 s and a rest to interpolate by,
/// so that the simulation is the same at any display rate.
/// Source: G. Fiedler, "Fix Your Timestep!", 2004.
class StepClock {
public:
    static constexpr double kStep = 1.0 / 60.0;    ///< s of a tick
    static constexpr double kLongestFrame = 0.25;  ///< s; a longer pause is a hitch, not time to catch up
    static constexpr int kMostTicks = 15;  ///< a frame; a machine that cannot keep up runs slower instead

    struct Frame {
        int ticks = 0;       ///< to simulate now
        float alpha = 0.0f;  ///< where between the last two ticks to draw (ratio, 0..1)
    };

    /// @param seconds  since the frame before; negative and NaN count as 0
    /// @param speed    of the game against the clock (ratio; 1 is real time)
    Frame advance(double seconds, double speed = 1.0);

    /// Forgets what was left over: after a pause, a load, or when the window comes back.
    void reset() { rest_ = 0.0; }

private:
    double rest_ = 0.0;  // s not yet simulated, 0..kStep
};

/// The frame time that a display of `rate` Hz must have meant: measured times jitter by fractions of a
/// millisecond around whole multiples of its period, and a sprite drawn by them would, too.
double snappedToRefresh(double seconds, double rate);

}  // namespace plumb
