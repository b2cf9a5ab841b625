#pragma once

#include <cstdint>
#include <span>

#include "assets/animation.hpp"

namespace plumb {

/// Where a clip stands. Plain data: the state of one Animator.
struct ClipCursor {
    int frame = 0;       ///< index in the clip
    float timer = 0.0f;  ///< s since the frame began
    int direction = 0;   ///< 1 forth, -1 on the way back of a ping-pong clip; 0 until the clip has begun
    bool ended = false;  ///< has reached its end at least once; a clip that plays once then stands still

    friend bool operator==(const ClipCursor&, const ClipCursor&) = default;
};

/// Time inside an animation is counted in these, so that a clip keeps its length over any number of ticks: a
/// tick of 1/60 s, 1/120 s or 1/144 s and every whole millisecond is a whole number of them.
inline constexpr double kAnimationUnit = 1.0 / 720000.0;  ///< s

/// One advance of a cursor, frame by frame: `next` until it gives no more. Changes only the cursor.
class ClipAdvance {
public:
    /// @param mode     the clip's own, or Once to stop any clip after one turn
    /// @param seconds  of play, times the speed; negative plays backwards, 0 only begins the clip
    ClipAdvance(const Animation& clip, LoopMode mode, ClipCursor& cursor, float seconds);

    /// The frame that is entered next, or -1 when the time is used up. A time longer than two turns of the
    /// clip leaves out whole turns: their events are not emitted.
    int next();

private:
    bool begin();
    bool enterNeighbour(bool forth);
    [[nodiscard]] std::int64_t turnLength() const;

    const Animation& clip_;
    LoopMode mode_;
    ClipCursor& cursor_;
    std::int64_t left_;   // units of time still to play
    std::int64_t timer_;  // units since the frame began
};

/// Advances a clip and calls `onFrame(index)` for every frame that begins, in order.
template <class OnFrame>
void advanceClip(const Animation& clip, LoopMode mode, ClipCursor& cursor, float seconds, OnFrame&& onFrame) {
    ClipAdvance advance{clip, mode, cursor, seconds};
    for (int frame = advance.next(); frame >= 0; frame = advance.next()) onFrame(frame);
}

/// Whether a condition is met by this value of its parameter.
bool holds(const AnimationCondition& condition, float value);

/// Takes at most one transition: the first in the file's order whose conditions hold. Triggers it used fall
/// to 0.
/// @param state       index in the states
/// @param parameters  values in the order of the set's parameters; missing ones count as 0
/// @param clipEnded   the cursor's `ended`
/// @return            the state after; the caller restarts its clip when it changed
int advanceStateMachine(const AnimationSet& set, int state, std::span<float> parameters, bool clipEnded);

}  // namespace plumb
