#include "physics/islands/substep_controller.hpp"

#include <algorithm>
#include <cmath>

#include "physics/edits.hpp"
#include "physics/islands/quality.hpp"
#include "physics/measure/measures.hpp"
#include "physics/tuning.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

/// Parameters of the decisions about an island.
struct Terms {
    float tolerance = 0.0f;  ///< m
    float dt = 0.0f;         ///< s
    Quality minimum = 0;

    [[nodiscard]] std::uint32_t stepsIn(float seconds) const {
        return static_cast<std::uint32_t>(std::min(seconds / dt + 0.5f, 1.0e6f));
    }
};

/// Returns the number of additional quality levels with which an error falls below the tolerance.
int levelsFor(float error, float tolerance) {
    int levels = 0;
    for (float left = error; levels < kMaxQuality && left > kRoom * tolerance; left *= 1.0f / kMinGain)
        ++levels;
    return levels;
}

std::uint8_t oneMore(std::uint8_t patience) {
    return static_cast<std::uint8_t>(std::min<int>(patience + 1, kMaxPatience));
}

SubstepController changed(SubstepController controller, SubstepPhase phase, std::uint32_t wait, float error) {
    controller.phase = phase;
    controller.wait = wait;
    controller.error = error;
    return controller;
}

SubstepController watching(const SubstepController& controller, SubstepPhase phase, const Terms& terms) {
    return changed(controller, phase, terms.stepsIn(kWatch) << controller.patience, 0.0f);
}

SubstepController resigned(SubstepController controller, float error, const Terms& terms) {
    controller.patience = oneMore(controller.patience);
    const std::uint32_t wait = terms.stepsIn(kResignation) << controller.patience;
    return changed(controller, SubstepPhase::Resigned, wait, error);
}

/// Returns the quality up to which a rise continues.
Quality goalOf(const SubstepController& controller, const Terms& terms) {
    const int levels = std::max(1, levelsFor(controller.first, terms.tolerance));
    return static_cast<Quality>(std::min(controller.before + levels, int{kMaxQuality}));
}

SubstepController oneHigher(SubstepController controller, float error, const Terms& terms) {
    ++controller.quality;
    const float time = controller.quality < goalOf(controller, terms) ? kClimb : kSettling;
    return changed(controller, SubstepPhase::Rising, terms.stepsIn(time), error);
}

SubstepController risen(SubstepController controller, float error, const Terms& terms) {
    if (controller.quality == kMaxQuality) return resigned(controller, error, terms);
    controller.before = controller.quality;
    controller.first = error;
    return oneHigher(controller, error, terms);
}

SubstepController strained(const SubstepController& controller, const Terms& terms) {
    return changed(controller, SubstepPhase::Strained, terms.stepsIn(kBlow), controller.error);
}

/// Next state while the error is within the tolerance.
SubstepController whileCalm(SubstepController controller, float error, const Terms& terms) {
    controller.error = std::max(controller.error, error);
    // Then earlier failures were with another load.
    if (controller.patience > 0 && error < kVanished * controller.first) {
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

SubstepController whileTrying(SubstepController controller, float error, const Terms& terms) {
    if (error <= kRoom * terms.tolerance) return whileCalm(controller, error, terms);
    // Perhaps an impact caused the error, which cannot be detected here: tries the lower quality again later.
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
    if (error < kStillFalls * controller.error)
        return changed(controller, SubstepPhase::Rising, terms.stepsIn(kSettling), error);
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

bool isRoot(const World& world, std::uint32_t body) {
    return isDynamic(world, body) && world.bodies.info[body].island == body;
}

/// Result of openCases().
struct Findings {
    bool someNew = false;      // true if a body has no controller yet
    bool someChanged = false;  // true if an island merges bodies of different quality
};

/// Collects the bodies of each island and merges their states.
Findings openCases(World& world, Workspace& work) {
    const bool wishes = world.qualityCallers != 0;
    Findings found;
    for (const std::uint32_t body : world.awake) {
        if (isRoot(world, body)) work.cases[body] = {};
    }
    for (const std::uint32_t body : world.awake) {
        if (!isDynamic(world, body)) continue;
        IslandCase& island = work.cases[work.roots[body]];
        const SubstepController& controller = world.bodies.substepControllers[body];
        const Quality others = island.controller.quality;
        found.someChanged |= others != kQualityOfWorld && others != controller.quality;
        island.controller = merged(island.controller, controller);
        if (wishes) island.minimum = std::max(island.minimum, requestedQualityOf(world, body));
        if (controller.quality == kQualityOfWorld) island.isNew = found.someNew = true;
    }
    return found;
}

void measure(World& world, Workspace& work) {
    const auto note = [&](std::uint32_t a, std::uint32_t b, float error) {
        float& maximum = work.cases[work.roots[isDynamic(world, b) ? b : a]].error;
        maximum = std::max(maximum, error);
    };
    if (world.manifest.runs(Effect::Contacts)) {
        for (std::size_t i = 0; i < work.contactKeys.size(); ++i) {
            if (!pushes(work.contactKeys[i])) continue;
            const Contact& contact = world.contacts[i];
            if (const float overlap = overlapOf(contact); overlap > 0.0f)
                note(contact.bodyA, contact.bodyB, overlap);
        }
    }
    if (!world.manifest.runs(Effect::Joints)) return;
    for (const std::uint32_t j : world.joints.awake) {
        const Joint& joint = world.joints.hot[j];
        note(joint.bodyA, joint.bodyB, openingOf(world, j));
    }
}

/// Starts new islands with the estimated quality, so that bodies do not have to overlap before it rises.
void guess(World& world, Workspace& work) {
    estimateSubsteps(world, work);
    for (const std::uint32_t body : world.awake) {
        const std::uint32_t root = work.roots[body];
        IslandCase& island = work.cases[root];
        if (!island.isNew) continue;
        const int guessed =
            std::min(world.settings.quality + extraQuality(work.estimate[root]), int{kMaxQuality});
        if (island.controller.quality < guessed)
            island.controller = begun(static_cast<Quality>(guessed), world.stepLength);
        island.isNew = false;
    }
}

/// @return true if the quality of some island changed
bool judge(World& world, Workspace& work) {
    bool changed = false;
    for (const std::uint32_t body : world.awake) {
        if (!isRoot(world, body)) continue;
        IslandCase& island = work.cases[body];
        const Quality before = island.controller.quality;
        island.controller = judged(island.controller, island.error, world.settings.tolerance, island.minimum,
                                   world.stepLength);
        changed |= island.controller.quality != before;
    }
    return changed;
}

/// Scales the impulses per substep of contacts to the new substep length. Joints store forces instead.
void scaleImpulses(World& world, Workspace& work) {
    for (Contact& contact : world.contacts) {
        if ((contact.flags & (kTouching | kTriggered)) != kTouching) continue;
        const Quality before = world.bodies.substepControllers[contact.bodyB].quality;
        if (world.bodies.info[contact.bodyB].awakeIndex == kNone || before == kQualityOfWorld) continue;
        const int change = before - work.cases[work.roots[contact.bodyB]].controller.quality;
        if (change == 0) continue;
        const float ratio = std::ldexp(1.0f, change);
        for (float* impulse :
             {&contact.impulse0, &contact.impulse1, &contact.frictionImpulse, &contact.rollingImpulse})
            *impulse *= ratio;
    }
}

/// Gives kinematic bodies the quality of the bodies that are joined to them, so that they are in the same
/// group. Otherwise the joint would be inaccurate.
void takeAlong(const World& world, Workspace& work) {
    if (!world.manifest.runs(Effect::Kinematics)) return;
    for (const std::uint32_t j : world.joints.awake) {
        const Joint& joint = world.joints.hot[j];
        if (isDynamic(world, joint.bodyA) && isDynamic(world, joint.bodyB)) continue;
        const std::uint32_t pushed = isDynamic(world, joint.bodyA) ? joint.bodyA : joint.bodyB;
        const std::uint32_t other = pushed == joint.bodyA ? joint.bodyB : joint.bodyA;
        work.bodyScratch[other] = std::max(work.bodyScratch[other], work.bodyScratch[pushed]);
    }
}

void takeDown(World& world, Workspace& work) {
    work.bodyScratch.assign(world.bodies.size(), 0);
    for (const std::uint32_t body : world.awake) {
        if (!isDynamic(world, body)) continue;
        const SubstepController& controller = work.cases[work.roots[body]].controller;
        world.bodies.substepControllers[body] = controller;
        work.bodyScratch[body] = static_cast<std::uint32_t>(std::max(controller.quality, Quality{0}));
    }
    takeAlong(world, work);
}

}  // namespace

SubstepController merged(const SubstepController& a, const SubstepController& b) {
    if (a.quality != b.quality) return a.quality > b.quality ? a : b;
    return {.quality = a.quality,
            .before = std::max(a.before, b.before),
            .phase = std::max(a.phase, b.phase),
            .patience = std::max(a.patience, b.patience),
            .wait = std::max(a.wait, b.wait),
            .error = std::max(a.error, b.error),
            .first = std::max(a.first, b.first)};
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

Quality requestedQualityOf(const World& world, std::uint32_t body) {
    Quality wish = world.bodies.info[body].quality;
    forJointsOf(world, body, [&](std::uint32_t j) { wish = std::max(wish, world.joints.hot[j].quality); });
    return wish;
}

void holdTolerance(World& world, Workspace& work) {
    world.bodies.substepControllers.resize(world.bodies.size());
    work.cases.resize(world.bodies.size());
    const Findings found = openCases(world, work);
    measure(world, work);
    if (found.someNew) guess(world, work);
    if (judge(world, work) || found.someNew || found.someChanged) scaleImpulses(world, work);
    takeDown(world, work);
}

}  // namespace plumb::physics
