#include "assets/clip_cursor.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

constexpr double kMaxSeconds = 1e6;  // maximum time of one advance

/// Converts to kAnimationUnit, rounded to nearest; NaN becomes 0.
std::int64_t unitsOf(float seconds) {
    if (!(seconds == seconds)) return 0;
    const double clamped = std::clamp(static_cast<double>(seconds), -kMaxSeconds, kMaxSeconds);
    return static_cast<std::int64_t>(std::floor(clamped / kAnimationUnit + 0.5));
}

float secondsOf(std::int64_t units) {
    return static_cast<float>(static_cast<double>(units) * kAnimationUnit);
}

std::int64_t lengthOf(const AnimationFrame& frame) {
    return std::max<std::int64_t>(unitsOf(frame.seconds), 1);
}

bool applies(const AnimationTransition& transition, int state, std::span<const float> parameters,
             bool clipEnded) {
    const bool fromHere = transition.from == state ||
                          (transition.from == AnimationTransition::kAnyState && transition.to != state);
    if (!fromHere || (transition.afterEnd && !clipEnded)) return false;
    return std::all_of(transition.when.begin(), transition.when.end(),
                       [&](const AnimationCondition& condition) {
                           const auto index = static_cast<std::size_t>(condition.parameter);
                           return holds(condition, index < parameters.size() ? parameters[index] : 0.0f);
                       });
}

}  // namespace

ClipAdvance::ClipAdvance(const Animation& clip, LoopMode mode, ClipCursor& cursor, float seconds)
    : clip_{clip}, mode_{mode}, cursor_{cursor}, left_{unitsOf(seconds)}, timer_{unitsOf(cursor.timer)} {
    if (clip.frames.empty()) {
        left_ = 0;
        return;
    }
    cursor_.frame = std::clamp(cursor_.frame, 0, static_cast<int>(clip.frames.size()) - 1);
    const std::int64_t cycle = cycleLength();
    if (mode_ != LoopMode::Once && std::abs(left_) > 2 * cycle) left_ %= cycle;
}

std::int64_t ClipAdvance::cycleLength() const {
    std::int64_t length = 0;
    for (const AnimationFrame& frame : clip_.frames) length += lengthOf(frame);
    if (mode_ != LoopMode::PingPong || clip_.frames.size() < 2) return length;
    return 2 * length - lengthOf(clip_.frames.front()) - lengthOf(clip_.frames.back());
}

bool ClipAdvance::begin() {
    if (cursor_.direction != 0) return false;
    cursor_.direction = 1;
    return true;
}

/// Steps to the next or previous frame in playback order. @return false at the end of a clip of mode Once
bool ClipAdvance::enterAdjacentFrame(bool forward) {
    const int last = static_cast<int>(clip_.frames.size()) - 1;
    const bool upwards = forward == (cursor_.direction > 0);
    const bool atEdge = cursor_.frame == (upwards ? last : 0);
    if (!atEdge) {
        cursor_.frame += upwards ? 1 : -1;
        // A cycle of a ping-pong clip ends when it is back at its first frame.
        cursor_.ended = cursor_.ended || (mode_ == LoopMode::PingPong && cursor_.frame == 0);
        return true;
    }
    cursor_.ended = cursor_.ended || mode_ != LoopMode::PingPong || last == 0;
    if (mode_ == LoopMode::Once) return false;
    if (mode_ == LoopMode::Loop || last == 0) {
        cursor_.frame = upwards ? 0 : last;
        return true;
    }
    cursor_.direction = -cursor_.direction;
    cursor_.frame += upwards ? -1 : 1;
    cursor_.ended = cursor_.ended || cursor_.frame == 0;
    return true;
}

int ClipAdvance::next() {
    if (clip_.frames.empty()) return -1;
    if (begin()) return cursor_.frame;
    if (left_ == 0) return -1;
    const bool forward = left_ > 0;
    const std::int64_t length = lengthOf(clip_.frames[static_cast<std::size_t>(cursor_.frame)]);
    const std::int64_t reached = timer_ + left_;
    if (forward ? reached < length : reached >= 0) {
        timer_ = reached;
        left_ = 0;
    } else if (!enterAdjacentFrame(forward)) {
        timer_ = forward ? length : 0;
        left_ = 0;
    } else {
        left_ = forward ? reached - length : reached;
        timer_ = forward ? 0 : lengthOf(clip_.frames[static_cast<std::size_t>(cursor_.frame)]);
        cursor_.timer = secondsOf(timer_);
        return cursor_.frame;
    }
    cursor_.timer = secondsOf(timer_);
    return -1;
}

bool holds(const AnimationCondition& condition, float value) {
    switch (condition.is) {
        case Comparison::Greater: return value > condition.value;
        case Comparison::Less: return value < condition.value;
        case Comparison::GreaterOrEqual: return value >= condition.value;
        case Comparison::LessOrEqual: return value <= condition.value;
        case Comparison::Equal: return value == condition.value;
        case Comparison::NotEqual: return value != condition.value;
    }
    return false;
}

int advanceStateMachine(const AnimationSet& set, int state, std::span<float> parameters, bool clipEnded) {
    for (const AnimationTransition& transition : set.transitions) {
        if (!applies(transition, state, parameters, clipEnded)) continue;
        for (const AnimationCondition& condition : transition.when) {
            const auto index = static_cast<std::size_t>(condition.parameter);
            if (index < parameters.size() && index < set.parameters.size() &&
                set.parameters[index].kind == ParameterKind::Trigger) {
                parameters[index] = 0.0f;
            }
        }
        return transition.to;
    }
    return state;
}

}  // namespace plumb
