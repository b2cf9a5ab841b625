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

/// Returns the number of additional quality levels with which an error falls below the tolerance.
int levelsFor(float error, float tolerance) {
    int levels = 0;
    for (; levels < kMaxQuality && error > kRoom * tolerance; error *= 1.0f / kMinGain) ++levels;
    return levels;
}

/// The decision about the next state of an island's controller.
struct Decision {
    SubstepController now;
    float error = 0.0f;      ///< m: of the island after the last step
    float tolerance = 0.0f;  ///< m
    Quality minimum = 0;
    float dt = 0.0f;  ///< s

    [[nodiscard]] std::uint32_t stepsIn(float seconds) const {
        return static_cast<std::uint32_t>(std::min(seconds / dt + 0.5f, 1.0e6f));
    }
    [[nodiscard]] std::uint8_t morePatience() const {
        return static_cast<std::uint8_t>(std::min<int>(now.patience + 1, kMaxPatience));
    }
    /// Returns the quality up to which a rise continues.
    [[nodiscard]] Quality goal() const {
        return static_cast<Quality>(
            std::min(now.before + std::max(1, levelsFor(now.first, tolerance)), int{kMaxQuality}));
    }

    void enter(SubstepPhase phase, std::uint32_t wait, float noted) {
        now.phase = phase;
        now.wait = wait;
        now.error = noted;
    }
    void watch(SubstepPhase phase = SubstepPhase::Calm) {
        enter(phase, stepsIn(kWatch) << now.patience, 0.0f);
    }
    void strain() { enter(SubstepPhase::Strained, stepsIn(kBlow), now.error); }
    void resign() {
        now.patience = morePatience();
        enter(SubstepPhase::Resigned, stepsIn(kResignation) << now.patience, error);
    }
    void climb() {
        ++now.quality;
        enter(SubstepPhase::Rising, stepsIn(now.quality < goal() ? kClimb : kSettling), error);
    }
    void rise() {
        if (now.quality == kMaxQuality) return resign();
        now.before = now.quality;
        now.first = error;
        climb();
    }

    /// While the error is within the tolerance.
    void whileCalm() {
        now.error = std::max(now.error, error);
        if (now.patience > 0 && error < kVanished * now.first) {  // earlier failures were with another load
            now.patience = 0;
            now.wait = std::min(now.wait, stepsIn(kWatch));
        }
        if (now.wait > 0) return;
        if (now.phase == SubstepPhase::Trying) {
            now.before = now.quality;
            if (now.patience > 0) --now.patience;
        }
        if (now.quality <= minimum || now.error * kMaxGain > kRoom * tolerance) return watch();
        now.before = now.quality--;
        watch(SubstepPhase::Trying);
    }
    void whileTrying() {
        if (error <= kRoom * tolerance) return whileCalm();
        // Perhaps an impact caused the error, which cannot be detected here: tries the lower quality again.
        const std::uint8_t patience = morePatience();
        rise();
        now.patience = patience;
    }
    void whileRising() {
        if (error <= tolerance) return watch();
        if (error > kGrew * now.first) now.first = error;  // the load has grown
        if (now.wait > 0) return;
        if (now.quality < goal()) return climb();
        if (error < kStillFalls * now.error) return enter(SubstepPhase::Rising, stepsIn(kSettling), error);
        if (error < kHelped * now.first) return rise();
        now.quality = now.before;
        resign();
    }
    void whileResigned() {
        if (error <= tolerance) return watch();
        const bool isOver = now.wait == 0 && now.quality < kMaxQuality;
        const bool isAnother = error > kGrew * now.error || error < kHelped * now.error;
        if (isOver || isAnother) strain();
    }
    void decide() {
        if (now.wait > 0) --now.wait;
        if (now.quality < minimum) {
            now.quality = minimum;
            return watch();
        }
        switch (now.phase) {
            case SubstepPhase::Calm: return error > tolerance ? strain() : whileCalm();
            case SubstepPhase::Trying: return whileTrying();
            case SubstepPhase::Strained:
                if (error <= tolerance) return watch();
                if (now.wait == 0) rise();
                return;
            case SubstepPhase::Rising: return whileRising();
            case SubstepPhase::Resigned: return whileResigned();
        }
    }
};

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
    Decision decision{.now = {.quality = quality}, .dt = dt};
    decision.watch();
    return decision.now;
}

SubstepController judged(SubstepController controller, float error, float tolerance, Quality minimum,
                         float dt) {
    Decision decision{controller, error, tolerance, minimum, dt};
    decision.decide();
    return decision.now;
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
