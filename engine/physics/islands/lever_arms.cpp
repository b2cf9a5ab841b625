#include "physics/islands/lever_arms.hpp"

#include <algorithm>
#include <bit>

#include "physics/islands/substep_estimate.hpp"
#include "physics/joints/joint_types.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

/// Square of the ratio of an arm to the radius of gyration.
float squareOf(const World& world, std::uint32_t body, Vec2 anchor) {
    const BodyMass& mass = world.bodies.mass[body];
    return lengthSquared(anchor - world.bodies.pose[body].localCentre) * mass.mass * mass.inverseInertia;
}

/// True if other constraints than this joint act on the body.
bool meetsOthers(const Workspace& work, std::uint32_t body) {
    return !std::has_single_bit(work.colourMasks[body]) && work.colourMasks[body] != 0;
}

/// Lever-arm level of a joint that the SIMD solver solves sequentially with other constraints; 0 for all
/// others.
std::uint8_t leverageNow(const World& world, const Workspace& work, std::uint32_t index) {
    const std::uint8_t leverage = work.joints.leverages[index];
    if (leverage == 0 || work.joints.trees.isDirect[index] != 0) return 0;
    const Joint& joint = world.joints.hot[index];
    // A tree that was left to the SIMD solver touched something, and is about to do so again.
    const bool leftByTree = world.settings.directJoints;
    return leftByTree || meetsOthers(work, joint.bodyA) || meetsOthers(work, joint.bodyB) ? leverage : 0;
}

}  // namespace

std::uint8_t leverageOf(const World& world, std::uint32_t index) {
    const Joint& joint = world.joints.hot[index];
    if (jointType(joint.kind).constraint != nullptr) return 0;
    const JointDefinition& definition = world.joints.definition[index];
    const float b = squareOf(world, joint.bodyB, definition.anchorB);
    const float a = joint.kind == JointKind::Mouse ? 0.0f : squareOf(world, joint.bodyA, definition.anchorA);
    std::uint8_t leverage = 0;
    for (float limit = 64.0f; leverage < kMaxLeverage && std::max(a, b) >= limit; limit *= 4.0f) ++leverage;
    return leverage;
}

void findLeverages(const World& world, Workspace& work) {
    std::vector<std::uint8_t>& leverages = work.joints.leverages;
    leverages.assign(world.joints.size(), 0);
    work.joints.someLeverage = false;
    for (const std::uint32_t joint : world.joints.awake) {
        leverages[joint] = leverageOf(world, joint);
        work.joints.someLeverage |= leverages[joint] > 0;
    }
}

bool hasLeverage(const World& world, const Workspace& work) {
    if (!work.joints.someLeverage || !world.manifest.runs(Effect::Joints)) return false;
    return std::any_of(world.joints.awake.begin(), world.joints.awake.end(),
                       [&](std::uint32_t joint) { return leverageNow(world, work, joint) > 0; });
}

void judgeLeverages(World& world, Workspace& work) {
    work.leverageOf.assign(world.bodies.size(), 0);
    for (const std::uint32_t j : world.joints.awake) {
        const std::uint8_t leverage = leverageNow(world, work, j);
        if (leverage == 0) continue;
        const Joint& joint = world.joints.hot[j];
        for (const std::uint32_t body : {joint.bodyA, joint.bodyB}) {
            std::uint8_t& maximum = work.leverageOf[work.roots[body]];
            maximum = std::max(maximum, leverage);
        }
    }
}

}  // namespace plumb::physics
