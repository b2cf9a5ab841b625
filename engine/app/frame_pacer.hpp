#pragma once

#include "app/step_clock.hpp"

namespace plumb {

/// Computes for every frame how many ticks to simulate and the ratio at which to interpolate between the last
/// two. Frame times are rounded to whole periods of the display to remove jitter; the rounding error is
/// carried over to the next frame, so the game keeps pace with the clock.
class FramePacer {
public:
    /// @param refreshRate  refresh rate of the display, Hz; 0: unknown
    explicit FramePacer(double refreshRate = 0.0) : refreshRate_{refreshRate} {}

    /// @param seconds  s since the previous frame
    StepClock::Frame next(double seconds);

    /// Returns the time to sleep before the next frame (s), for drivers without vertical synchronization:
    /// limits the frame rate to twice the display's refresh rate, or to kUnknownRate if that is unknown.
    /// @param seconds  s since the last frame began
    [[nodiscard]] double rest(double seconds) const;
    static constexpr double kUnknownRate = 120.0;  ///< Hz, maximum frame rate if the refresh rate is unknown

    /// @param rate  refresh rate of the display, Hz; 0: unknown
    void setRefreshRate(double rate) { refreshRate_ = rate; }
    /// Limits the frame rate. @param rate  Hz; 0: see rest()
    void setCap(double rate) { cap_ = rate; }

    /// Stops the game time; next() returns 0 ticks and the last interpolation ratio.
    void pause() { paused_ = true; }
    /// Resumes the game time from now on: the frame in which a pause ends is part of it.
    void resume() {
        resumes_ = resumes_ || paused_;
        paused_ = false;
    }
    [[nodiscard]] bool paused() const { return paused_; }

private:
    StepClock clock_;
    double refreshRate_;
    double cap_ = 0.0;        // Hz, set by the player; 0: none
    double remainder_ = 0.0;  // s, measured time not yet passed to the clock; negative after rounding up
    float alpha_ = 1.0f;
    bool paused_ = false;
    bool resumes_ = false;  // since the last frame
};

}  // namespace plumb
