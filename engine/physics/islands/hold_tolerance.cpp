#include <algorithm>

#include "physics/islands/quality.hpp"
#include "physics/islands/substep_controller.hpp"
#include "physics/measure/measures.hpp"
#include "physics/model/edits.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

bool isRoot(const World& world, std::uint32_t body) {
    return isDynamic(world, body) && world.bodies.info[body].island == body;
}

/// What is known before errors are measured.
struct Findings {
    bool someNew = false;      // some bodies have no state yet
    bool someChanged = false;  // some island merges bodies of different quality
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
        if (wishes) island.minimum = std::max(island.minimum, wishOf(world, body));
        if (controller.quality != kQualityOfWorld) continue;
        island.isNew = found.someNew = true;
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

/// New islands begin with the estimate, so that nothing has to sink in before an error shows.
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

float powerOfTwo(int exponent) {
    return exponent < 0 ? 1.0f / static_cast<float>(1 << -exponent) : static_cast<float>(1 << exponent);
}

/// Impulses are those of a substep: in a longer one the same force has a larger impulse. Joints store forces.
void scaleImpulses(World& world, Workspace& work) {
    for (Contact& contact : world.contacts) {
        if ((contact.flags & (kTouching | kTriggered)) != kTouching) continue;
        const Quality before = world.bodies.substepControllers[contact.bodyB].quality;
        if (world.bodies.info[contact.bodyB].place == kNone || before == kQualityOfWorld) continue;
        const int change = before - work.cases[work.roots[contact.bodyB]].controller.quality;
        if (change == 0) continue;
        const float ratio = powerOfTwo(change);
        for (float* impulse :
             {&contact.impulse0, &contact.impulse1, &contact.frictionImpulse, &contact.rollingImpulse})
            *impulse *= ratio;
    }
}

/// A joint to a kinematic body is accurate only if both are solved in the same group.
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

Quality wishOf(const World& world, std::uint32_t body) {
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
