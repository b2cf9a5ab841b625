#include "physics/islands/substep_controller.hpp"

#include <algorithm>

namespace plumb::physics {

namespace {

// Range of the factor by which one more quality level (twice the substeps) reduces the error: 4 for
// compliance, less for the convergence of bodies stacked on each other.
constexpr float kMinGain = 3.0f;
constexpr float kMaxGain = 4.5f;

constexpr float kRoom = 0.8f;  // ratio to the tolerance: the error that a quality should reach

constexpr std::uint32_t kBlow = 3;  // steps in which the overlap of an impact decays by itself
/// Steps for each level of a rise. Deep overlap is a loaded spring: released at once, a stack of 16 whose
/// boxes are 2 cm deep hops by 1.7 m; one level at a time it hardly moves (measured; with 4 steps it hops by
/// 0.2 m).
constexpr std::uint32_t kClimb = 8;
constexpr std::uint32_t kSettling = 20;      // steps, about: until bodies have come out of each other
constexpr std::uint32_t kWatch = 30;         // calm steps after which a lower quality is tried
constexpr std::uint32_t kResignation = 240;  // steps after which a rise that did not help is tried again
constexpr std::uint8_t kMaxPatience = 5;

constexpr float kStillFalls = 0.9f;  // ratio to an earlier error: still decreasing, no need for more yet
constexpr float kHelped = 0.6f;      // ratio to the error before the rise
constexpr float kGrew = 1.5f;        // the same: the load has grown
constexpr float kVanished = 0.02f;   // the same: most of the load is gone

/// Number of additional quality levels that an error calls for.
int levelsFor(float error, float tolerance) {
    int levels = 0;
    for (float left = error; levels < kMaxQuality && left > kRoom * tolerance; left *= 1.0f / kMinGain)
        ++levels;
    return levels;
}

SubstepController watching(SubstepController controller, SubstepPhase phase) {
    controller.phase = phase;
    controller.wait = kWatch << controller.patience;
    controller.error = 0.0f;
    return controller;
}

SubstepController resigned(SubstepController controller, float error) {
    controller.phase = SubstepPhase::Resigned;
    controller.patience = std::min<std::uint8_t>(controller.patience + 1, kMaxPatience);
    controller.wait = kResignation << controller.patience;
    controller.error = error;
    return controller;
}

/// Quality that a rise aims at.
Quality goalOf(const SubstepController& controller, float tolerance) {
    const int levels = std::max(1, levelsFor(controller.first, tolerance));
    return static_cast<Quality>(std::min(controller.before + levels, int{kMaxQuality}));
}

SubstepController oneHigher(SubstepController controller, float error, float tolerance) {
    ++controller.quality;
    controller.wait = controller.quality < goalOf(controller, tolerance) ? kClimb : kSettling;
    controller.error = error;
    return controller;
}

SubstepController risen(SubstepController controller, float error, float tolerance) {
    if (controller.quality == kMaxQuality) return resigned(controller, error);
    controller.before = controller.quality;
    controller.first = error;
    controller.phase = SubstepPhase::Rising;
    return oneHigher(controller, error, tolerance);
}

SubstepController strained(SubstepController controller) {
    controller.phase = SubstepPhase::Strained;
    controller.wait = kBlow;
    return controller;
}

/// Within tolerance, as far as is known.
SubstepController whileCalm(SubstepController controller, float error, float tolerance, Quality minimum) {
    controller.error = std::max(controller.error, error);
    if (controller.patience > 0 &&
        error < kVanished * controller.first) {  // what was learned concerns another load
        controller.patience = 0;
        controller.wait = std::min(controller.wait, kWatch);
    }
    if (controller.wait > 0) return controller;
    if (controller.phase == SubstepPhase::Trying) {
        controller.before = controller.quality;
        if (controller.patience > 0) --controller.patience;
    }
    if (controller.quality <= minimum || controller.error * kMaxGain > kRoom * tolerance)
        return watching(controller, SubstepPhase::Calm);
    controller.before = controller.quality--;
    return watching(controller, SubstepPhase::Trying);
}

/// A lower quality is being tried.
SubstepController whileTrying(SubstepController controller, float error, float tolerance, Quality minimum) {
    if (error <= kRoom * tolerance) return whileCalm(controller, error, tolerance, minimum);
    // An impact would prove nothing, but cannot be distinguished here: it will be tried again.
    const std::uint8_t patience = std::min<std::uint8_t>(controller.patience + 1, kMaxPatience);
    controller = risen(controller, error, tolerance);
    controller.patience = patience;
    return controller;
}

SubstepController whileRising(SubstepController controller, float error, float tolerance) {
    if (error <= tolerance) return watching(controller, SubstepPhase::Calm);
    if (error > kGrew * controller.first) controller.first = error;  // the load has grown
    if (controller.wait > 0) return controller;
    if (controller.quality < goalOf(controller, tolerance)) return oneHigher(controller, error, tolerance);
    if (error < kStillFalls * controller.error) {
        controller.error = error;
        controller.wait = kSettling;
        return controller;
    }
    if (error < kHelped * controller.first) return risen(controller, error, tolerance);
    controller.quality = controller.before;
    return resigned(controller, error);
}

SubstepController whileResigned(SubstepController controller, float error, float tolerance) {
    if (error <= tolerance) return watching(controller, SubstepPhase::Calm);
    const bool isOver = controller.wait == 0 && controller.quality < kMaxQuality;
    const bool isAnother = error > kGrew * controller.error || error < kHelped * controller.error;
    return isOver || isAnother ? strained(controller) : controller;
}

}  // namespace

SubstepController merged(const SubstepController& a, const SubstepController& b) {
    if (a.quality != b.quality) return a.quality > b.quality ? a : b;
    SubstepController both;
    both.quality = a.quality;
    both.before = std::max(a.before, b.before);
    both.phase = std::max(a.phase, b.phase);
    both.patience = std::max(a.patience, b.patience);
    both.wait = std::max(a.wait, b.wait);
    both.error = std::max(a.error, b.error);
    both.first = std::max(a.first, b.first);
    return both;
}

SubstepController begun(Quality quality) {
    SubstepController controller;
    controller.quality = quality;
    return watching(controller, SubstepPhase::Calm);
}

SubstepController judged(SubstepController controller, float error, float tolerance, Quality minimum) {
    if (controller.wait > 0) --controller.wait;
    if (controller.quality < minimum) {
        controller.quality = minimum;
        return watching(controller, SubstepPhase::Calm);
    }
    switch (controller.phase) {
        case SubstepPhase::Calm:
            return error > tolerance ? strained(controller)
                                     : whileCalm(controller, error, tolerance, minimum);
        case SubstepPhase::Trying: return whileTrying(controller, error, tolerance, minimum);
        case SubstepPhase::Strained:
            if (error <= tolerance) return watching(controller, SubstepPhase::Calm);
            return controller.wait > 0 ? controller : risen(controller, error, tolerance);
        case SubstepPhase::Rising: return whileRising(controller, error, tolerance);
        case SubstepPhase::Resigned: return whileResigned(controller, error, tolerance);
    }
    return controller;
}

}  // namespace plumb::physics
