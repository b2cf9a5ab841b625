#include "physics/solver/effort.hpp"

#include <algorithm>

namespace plumb::physics {

namespace {

// Range of the factor by which one more quality level (twice the substeps) reduces the error: 4 for
// compliance, less for the convergence of bodies stacked on each other.
constexpr float kLeastGain = 3.0f;
constexpr float kMostGain = 4.5f;

constexpr float kRoom = 0.8f;  // ratio to the tolerance: the error that a quality should reach

constexpr std::uint32_t kBlow = 3;  // steps in which the overlap of an impact decays by itself
/// Steps for each level of a rise. Deep overlap is a loaded spring: released at once, a stack of 16 whose
/// boxes are 2 cm deep hops by 1.7 m; one level at a time it hardly moves (measured; with 4 steps it hops by
/// 0.2 m).
constexpr std::uint32_t kClimb = 8;
constexpr std::uint32_t kSettling = 20;      // steps, about: until bodies have come out of each other
constexpr std::uint32_t kWatch = 30;         // calm steps after which a lower quality is tried
constexpr std::uint32_t kResignation = 240;  // steps after which a rise that did not help is tried again
constexpr std::uint8_t kMostPatience = 5;

constexpr float kStillFalls = 0.9f;  // ratio to an earlier error: still decreasing, no need for more yet
constexpr float kHelped = 0.6f;      // ratio to the error before the rise
constexpr float kGrew = 1.5f;        // the same: the load has grown
constexpr float kVanished = 0.02f;   // the same: most of the load is gone

/// Number of additional quality levels that an error calls for.
int levelsFor(float error, float tolerance) {
    int levels = 0;
    for (float left = error; levels < kMaxQuality && left > kRoom * tolerance; left *= 1.0f / kLeastGain)
        ++levels;
    return levels;
}

Effort watching(Effort effort, EffortPhase phase) {
    effort.phase = phase;
    effort.wait = kWatch << effort.patience;
    effort.error = 0.0f;
    return effort;
}

Effort resigned(Effort effort, float error) {
    effort.phase = EffortPhase::Resigned;
    effort.patience = std::min<std::uint8_t>(effort.patience + 1, kMostPatience);
    effort.wait = kResignation << effort.patience;
    effort.error = error;
    return effort;
}

/// Quality that a rise aims at.
Quality goalOf(const Effort& effort, float tolerance) {
    const int levels = std::max(1, levelsFor(effort.first, tolerance));
    return static_cast<Quality>(std::min(effort.before + levels, int{kMaxQuality}));
}

Effort oneHigher(Effort effort, float error, float tolerance) {
    ++effort.quality;
    effort.wait = effort.quality < goalOf(effort, tolerance) ? kClimb : kSettling;
    effort.error = error;
    return effort;
}

Effort risen(Effort effort, float error, float tolerance) {
    if (effort.quality == kMaxQuality) return resigned(effort, error);
    effort.before = effort.quality;
    effort.first = error;
    effort.phase = EffortPhase::Rising;
    return oneHigher(effort, error, tolerance);
}

Effort strained(Effort effort) {
    effort.phase = EffortPhase::Strained;
    effort.wait = kBlow;
    return effort;
}

/// Within tolerance, as far as is known.
Effort whileCalm(Effort effort, float error, float tolerance, Quality least) {
    effort.error = std::max(effort.error, error);
    if (effort.patience > 0 && error < kVanished * effort.first) {  // what was learned concerns another load
        effort.patience = 0;
        effort.wait = std::min(effort.wait, kWatch);
    }
    if (effort.wait > 0) return effort;
    if (effort.phase == EffortPhase::Trying) {
        effort.before = effort.quality;
        if (effort.patience > 0) --effort.patience;
    }
    if (effort.quality <= least || effort.error * kMostGain > kRoom * tolerance)
        return watching(effort, EffortPhase::Calm);
    effort.before = effort.quality--;
    return watching(effort, EffortPhase::Trying);
}

/// A lower quality is being tried.
Effort whileTrying(Effort effort, float error, float tolerance, Quality least) {
    if (error <= kRoom * tolerance) return whileCalm(effort, error, tolerance, least);
    // An impact would prove nothing, but cannot be distinguished here: it will be tried again.
    const std::uint8_t patience = std::min<std::uint8_t>(effort.patience + 1, kMostPatience);
    effort = risen(effort, error, tolerance);
    effort.patience = patience;
    return effort;
}

Effort whileRising(Effort effort, float error, float tolerance) {
    if (error <= tolerance) return watching(effort, EffortPhase::Calm);
    if (error > kGrew * effort.first) effort.first = error;  // the load has grown
    if (effort.wait > 0) return effort;
    if (effort.quality < goalOf(effort, tolerance)) return oneHigher(effort, error, tolerance);
    if (error < kStillFalls * effort.error) {
        effort.error = error;
        effort.wait = kSettling;
        return effort;
    }
    if (error < kHelped * effort.first) return risen(effort, error, tolerance);
    effort.quality = effort.before;
    return resigned(effort, error);
}

Effort whileResigned(Effort effort, float error, float tolerance) {
    if (error <= tolerance) return watching(effort, EffortPhase::Calm);
    const bool isOver = effort.wait == 0 && effort.quality < kMaxQuality;
    const bool isAnother = error > kGrew * effort.error || error < kHelped * effort.error;
    return isOver || isAnother ? strained(effort) : effort;
}

}  // namespace

Effort merged(const Effort& a, const Effort& b) {
    if (a.quality != b.quality) return a.quality > b.quality ? a : b;
    Effort both;
    both.quality = a.quality;
    both.before = std::max(a.before, b.before);
    both.phase = std::max(a.phase, b.phase);
    both.patience = std::max(a.patience, b.patience);
    both.wait = std::max(a.wait, b.wait);
    both.error = std::max(a.error, b.error);
    both.first = std::max(a.first, b.first);
    return both;
}

Effort begun(Quality quality) {
    Effort effort;
    effort.quality = quality;
    return watching(effort, EffortPhase::Calm);
}

Effort judged(Effort effort, float error, float tolerance, Quality least) {
    if (effort.wait > 0) --effort.wait;
    if (effort.quality < least) {
        effort.quality = least;
        return watching(effort, EffortPhase::Calm);
    }
    switch (effort.phase) {
        case EffortPhase::Calm:
            return error > tolerance ? strained(effort) : whileCalm(effort, error, tolerance, least);
        case EffortPhase::Trying: return whileTrying(effort, error, tolerance, least);
        case EffortPhase::Strained:
            if (error <= tolerance) return watching(effort, EffortPhase::Calm);
            return effort.wait > 0 ? effort : risen(effort, error, tolerance);
        case EffortPhase::Rising: return whileRising(effort, error, tolerance);
        case EffortPhase::Resigned: return whileResigned(effort, error, tolerance);
    }
    return effort;
}

}  // namespace plumb::physics
