#include "physics/islands/substep_controller.hpp"

#include <algorithm>

#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// What an island is judged by.
struct Terms {
    float tolerance = 0.0f;  ///< m
    float dt = 0.0f;         ///< s
    Quality minimum = 0;

    [[nodiscard]] std::uint32_t stepsIn(float seconds) const {
        return static_cast<std::uint32_t>(std::min(seconds / dt + 0.5f, 1.0e6f));
    }
};

/// Number of additional quality levels that an error calls for.
int levelsFor(float error, float tolerance) {
    int levels = 0;
    for (float left = error; levels < kMaxQuality && left > kRoom * tolerance; left *= 1.0f / kMinGain)
        ++levels;
    return levels;
}

std::uint8_t oneMore(std::uint8_t patience) {
    return static_cast<std::uint8_t>(std::min<int>(patience + 1, kMaxPatience));
}

SubstepController watching(SubstepController controller, SubstepPhase phase, const Terms& terms) {
    controller.phase = phase;
    controller.wait = terms.stepsIn(kWatch) << controller.patience;
    controller.error = 0.0f;
    return controller;
}

SubstepController resigned(SubstepController controller, float error, const Terms& terms) {
    controller.phase = SubstepPhase::Resigned;
    controller.patience = oneMore(controller.patience);
    controller.wait = terms.stepsIn(kResignation) << controller.patience;
    controller.error = error;
    return controller;
}

/// Quality that a rise aims at.
Quality goalOf(const SubstepController& controller, const Terms& terms) {
    const int levels = std::max(1, levelsFor(controller.first, terms.tolerance));
    return static_cast<Quality>(std::min(controller.before + levels, int{kMaxQuality}));
}

SubstepController oneHigher(SubstepController controller, float error, const Terms& terms) {
    ++controller.quality;
    controller.wait =
        controller.quality < goalOf(controller, terms) ? terms.stepsIn(kClimb) : terms.stepsIn(kSettling);
    controller.error = error;
    return controller;
}

SubstepController risen(SubstepController controller, float error, const Terms& terms) {
    if (controller.quality == kMaxQuality) return resigned(controller, error, terms);
    controller.before = controller.quality;
    controller.first = error;
    controller.phase = SubstepPhase::Rising;
    return oneHigher(controller, error, terms);
}

SubstepController strained(SubstepController controller, const Terms& terms) {
    controller.phase = SubstepPhase::Strained;
    controller.wait = terms.stepsIn(kBlow);
    return controller;
}

/// Within the tolerance, as far as is known.
SubstepController whileCalm(SubstepController controller, float error, const Terms& terms) {
    controller.error = std::max(controller.error, error);
    if (controller.patience > 0 &&
        error < kVanished * controller.first) {  // what was learned concerns another load
        controller.patience = 0;
        controller.wait = std::min(controller.wait, terms.stepsIn(kWatch));
    }
    if (controller.wait > 0) return controller;
    if (controller.phase == SubstepPhase::Trying) {
        controller.before = controller.quality;
        if (controller.patience > 0) --controller.patience;
    }
    if (controller.quality <= terms.minimum || controller.error * kMaxGain > kRoom * terms.tolerance)
        return watching(controller, SubstepPhase::Calm, terms);
    controller.before = controller.quality--;
    return watching(controller, SubstepPhase::Trying, terms);
}

/// A lower quality is being tried.
SubstepController whileTrying(SubstepController controller, float error, const Terms& terms) {
    if (error <= kRoom * terms.tolerance) return whileCalm(controller, error, terms);
    // An impact would prove nothing, but cannot be distinguished here: it will be tried again.
    const std::uint8_t patience = oneMore(controller.patience);
    controller = risen(controller, error, terms);
    controller.patience = patience;
    return controller;
}

SubstepController whileRising(SubstepController controller, float error, const Terms& terms) {
    if (error <= terms.tolerance) return watching(controller, SubstepPhase::Calm, terms);
    if (error > kGrew * controller.first) controller.first = error;  // the load has grown
    if (controller.wait > 0) return controller;
    if (controller.quality < goalOf(controller, terms)) return oneHigher(controller, error, terms);
    if (error < kStillFalls * controller.error) {
        controller.error = error;
        controller.wait = terms.stepsIn(kSettling);
        return controller;
    }
    if (error < kHelped * controller.first) return risen(controller, error, terms);
    controller.quality = controller.before;
    return resigned(controller, error, terms);
}

SubstepController whileResigned(SubstepController controller, float error, const Terms& terms) {
    if (error <= terms.tolerance) return watching(controller, SubstepPhase::Calm, terms);
    const bool isOver = controller.wait == 0 && controller.quality < kMaxQuality;
    const bool isAnother = error > kGrew * controller.error || error < kHelped * controller.error;
    return isOver || isAnother ? strained(controller, terms) : controller;
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

SubstepController begun(Quality quality, float dt) {
    SubstepController controller;
    controller.quality = quality;
    return watching(controller, SubstepPhase::Calm, {.dt = dt});
}

SubstepController judged(SubstepController controller, float error, float tolerance, Quality minimum,
                         float dt) {
    const Terms terms{tolerance, dt, minimum};
    if (controller.wait > 0) --controller.wait;
    if (controller.quality < minimum) {
        controller.quality = minimum;
        return watching(controller, SubstepPhase::Calm, terms);
    }
    switch (controller.phase) {
        case SubstepPhase::Calm:
            return error > tolerance ? strained(controller, terms) : whileCalm(controller, error, terms);
        case SubstepPhase::Trying: return whileTrying(controller, error, terms);
        case SubstepPhase::Strained:
            if (error <= tolerance) return watching(controller, SubstepPhase::Calm, terms);
            return controller.wait > 0 ? controller : risen(controller, error, terms);
        case SubstepPhase::Rising: return whileRising(controller, error, terms);
        case SubstepPhase::Resigned: return whileResigned(controller, error, terms);
    }
    return controller;
}

}  // namespace plumb::physics
