#pragma once

#include "app/step_clock.hpp"

namespace plumb {

/// Says before every frame of a window how many ticks to simulate and between which two of them to draw.
/// Frame times that jitter about the display's period count as whole periods; what that takes or gives is
/// owed to the next frame, so that the game never runs faster or slower than the clock.
class FramePacer {
public:
    /// @param refreshRate  Hz of the display; 0 when it is not known
    explicit FramePacer(double refreshRate = 0.0) : refreshRate_{refreshRate} {}

    /// @param seconds  since the frame before
    StepClock::Frame next(double seconds);

    /// How long to sleep before the next frame (s), for displays and drivers that do not wait: twice the
    /// display's rate is drawn at most, and kUnknownRate where it is not known.
    /// @param seconds  since the last frame began
    [[nodiscard]] double rest(double seconds) const;
    static constexpr double kUnknownRate = 120.0;  ///< Hz

    /// Stops the game's time. The picture stays what it was, between the same two ticks.
    void pause() { paused_ = true; }
    /// Goes on from there: the time between is no time of the game.
    void resume() { paused_ = false; }
    [[nodiscard]] bool paused() const { return paused_; }

private:
    StepClock clock_;
    double refreshRate_;
    double owed_ = 0.0;  // s measured and not yet given to the clock; negative after rounding up
    float alpha_ = 1.0f;
    bool paused_ = false;
};

}  // namespace plumb
