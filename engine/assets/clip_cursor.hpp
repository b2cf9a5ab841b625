#pragma once

#include <cstdint>
#include <span>

#include "assets/animation.hpp"

namespace plumb {

/// Playback position in a clip. Plain data: the state of one Animator.
struct ClipCursor {
    int frame = 0;       ///< index in the clip
    float timer = 0.0f;  ///< s since the frame began
    int direction = 0;   ///< 1: forward, -1: second half of a ping-pong clip, 0: the clip has not begun
    bool ended = false;  ///< has reached its end at least once; a clip of mode Once then stops

    friend bool operator==(const ClipCursor&, const ClipCursor&) = default;
};

/// Unit in which animation time is counted as an integer, so that rounding does not change a clip's length:
/// ticks of 1/60 s, 1/120 s and 1/144 s and every millisecond are integer multiples of it.
inline constexpr double kAnimationUnit = 1.0 / 720000.0;  ///< s

/// Advances a cursor by some time, frame by frame: call `next` until it returns -1. Changes only the cursor.
class ClipAdvance {
public:
    /// @param mode     the clip's loop mode, or Once to stop any clip after one cycle
    /// @param seconds  time times speed; negative plays backwards, 0 only begins the clip
    ClipAdvance(const Animation& clip, LoopMode mode, ClipCursor& cursor, float seconds);

    /// Returns the index of the next frame that begins, or -1 if no time is left. If the time is longer than
    /// two cycles of the clip, whole cycles are skipped: their events are not emitted.
    int next();

private:
    bool begin();
    bool enterAdjacentFrame(bool forward);
    [[nodiscard]] std::int64_t cycleLength() const;

    const Animation& clip_;
    LoopMode mode_;
    ClipCursor& cursor_;
    std::int64_t left_;   // remaining time, kAnimationUnit
    std::int64_t timer_;  // time since the frame began, kAnimationUnit
};

/// Advances a clip and calls `onFrame(index)` for every frame that begins, in order.
template <class OnFrame>
void advanceClip(const Animation& clip, LoopMode mode, ClipCursor& cursor, float seconds, OnFrame&& onFrame) {
    ClipAdvance advance{clip, mode, cursor, seconds};
    for (int frame = advance.next(); frame >= 0; frame = advance.next()) onFrame(frame);
}

/// True if the condition is met by a value of its parameter.
bool holds(const AnimationCondition& condition, float value);

/// Performs at most one transition: the first one, in the file's order, whose conditions are all true. Resets
/// the triggers in its conditions to 0.
/// @param state       index in the states
/// @param parameters  values in the order of the set's parameters; missing ones count as 0
/// @param clipEnded   the cursor's `ended`
/// @return            the new state; if it differs, the caller must restart its clip
int advanceStateMachine(const AnimationSet& set, int state, std::span<float> parameters, bool clipEnded);

}  // namespace plumb
