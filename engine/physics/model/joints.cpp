#include "physics/model/joints.hpp"

#include <algorithm>

#include "physics/bounds.hpp"
#include "physics/edits.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/joints/joint_types.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"
#include "physics/model/shapes.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

constexpr float kUnlimited = std::numeric_limits<float>::infinity();

Result<Done> checkNumbers(const JointDefinition& d) {
    return firstOf(checkVector("JointDefinition.anchorA", d.anchorA, kLargest),
                   checkVector("JointDefinition.anchorB", d.anchorB, kLargest),
                   checkVector("JointDefinition.axis", d.axis, kLargest),
                   checkNumber("JointDefinition.axis length", length(d.axis), 1.0e-6, 1.0e7),
                   checkNumber("JointDefinition.referenceAngle", d.referenceAngle, -1.0e5, 1.0e5),
                   checkNumber("JointDefinition.length", d.length, 0.0, kLargest),
                   checkNumber("JointDefinition.ratio", d.ratio, -kLargest, kLargest),
                   checkVector("JointDefinition.groundA", d.groundA, 1.0e9f),
                   checkVector("JointDefinition.groundB", d.groundB, 1.0e9f),
                   checkPosition("JointDefinition.target", d.target),
                   checkVector("JointDefinition.offset", d.offset, kLargest),
                   checkVector("JointDefinition.velocity", d.velocity, kFastest),
                   checkNumber("JointDefinition.limit.lower", d.limit.lower, -kLargest, kLargest),
                   checkNumber("JointDefinition.limit.upper", d.limit.upper, d.limit.lower, kLargest),
                   checkNumber("JointDefinition.motor.speed", d.motor.speed, -kFastest, kFastest),
                   checkNumber("JointDefinition.motor.maxForce", d.motor.maxForce, 0.0, kUnlimited),
                   checkNumber("JointDefinition.spring.hertz", d.spring.hertz, 0.0, 1.0e4),
                   checkNumber("JointDefinition.spring.dampingRatio", d.spring.dampingRatio, 0.0, 1.0e4),
                   checkNumber("JointDefinition.spring.rest", d.spring.rest, -kLargest, kLargest),
                   checkNumber("JointDefinition.maxForce", d.maxForce, 0.0, kUnlimited),
                   checkNumber("JointDefinition.maxTorque", d.maxTorque, 0.0, kUnlimited),
                   checkNumber("JointDefinition.breakForce", d.breakForce, 0.0, kUnlimited),
                   checkNumber("JointDefinition.breakTorque", d.breakTorque, 0.0, kUnlimited),
                   checkNumber("JointDefinition.reportForce", d.reportForce, 0.0, kUnlimited),
                   checkNumber("JointDefinition.reportTorque", d.reportTorque, 0.0, kUnlimited),
                   checkNumber("JointDefinition.hertz", d.hertz, 0.0, 1.0e4),
                   checkNumber("JointDefinition.dampingRatio", d.dampingRatio, 0.0, 1.0e4),
                   checkQuality("JointDefinition.quality", d.quality));
}

Result<Done> checkAngles(const JointDefinition& d) {
    if (d.kind != JointKind::Revolute) return Done{};
    const float limit = d.limit.on ? std::max(-d.limit.lower, d.limit.upper) : 0.0f;
    if (std::max(limit, d.spring.on ? std::fabs(d.spring.rest) : 0.0f) <= kPi) return Done{};
    return usageError("JointDefinition",
                      "expected limits and a rest angle from -pi to pi, because a hinge measures its "
                      "angle only within one revolution",
                      "to stop after several revolutions, integrate angularVelocityOf() and stop the motor");
}

Result<Done> check(const World& world, const JointDefinition& d) {
    if (d.kind >= JointKind::Count)
        return usageError("JointDefinition.kind", "expected a JointKind, found another number",
                          "use a constant of this enum");
    const auto living =
        firstOf(checkAlive("JointDefinition.a", world, d.a), checkAlive("JointDefinition.b", world, d.b));
    if (!living) return living;
    if (d.a == d.b) {
        return usageError("createJoint", "expected two bodies, found the same one twice",
                          "connect it to another body, such as a static one");
    }
    if (!canActOn(d.kind, world.bodies.info[d.a.index].kind, world.bodies.info[d.b.index].kind)) {
        return usageError("createJoint", "expected a dynamic body (for a mouse joint: body b), found none",
                          "make a body dynamic; for a mouse joint pass the pulled body as b");
    }
    const auto gears = [&](JointId joint) {
        if (!alive(world, joint)) return false;
        const JointKind kind = world.joints.hot[joint.index].kind;
        return kind == JointKind::Revolute || kind == JointKind::Prismatic;
    };
    if (d.kind == JointKind::Gear && (d.jointA == d.jointB || !(gears(d.jointA) && gears(d.jointB)))) {
        return usageError("createJoint",
                          "expected two different existing revolute or prismatic joints for the gear",
                          "create both first, and pass their ids as jointA and jointB");
    }
    if ((d.kind == JointKind::Gear && d.ratio == 0.0f) || (d.kind == JointKind::Pulley && d.ratio <= 0.0f)) {
        return usageError("JointDefinition.ratio", "expected a ratio other than 0 (for a pulley: above 0)",
                          "use 1 for equal displacements of both sides");
    }
    return firstOf(checkNumbers(d), checkAngles(d));
}

void callFor(World& world, const JointDefinition& definition, int times) {
    world.manifest.call(Effect::Joints, true, times);
    world.manifest.call(Effect::Motors, definition.motor.on, times);
    if (definition.quality != kQualityOfWorld) world.qualityCallers += static_cast<std::uint32_t>(times);
}

void unlink(World& world, std::uint32_t body, std::uint32_t joint, std::uint32_t next) {
    std::uint32_t* link = &world.bodies.info[body].firstJoint;
    while (*link != joint) {
        Joint& other = world.joints.hot[*link];
        link = other.bodyA == body ? &other.nextA : &other.nextB;
    }
    *link = next;
}

/// Makes the broad phase search the pairs of both bodies again, after a joint stopped preventing it.
void refreshPairs(World& world, const Joint& joint) {
    for (const std::uint32_t body : {joint.bodyA, joint.bodyB})
        forShapesOf(world, body, [&](std::uint32_t s) { noteMoved(world, s); });
}

std::uint8_t flagsOf(const JointDefinition& d) {
    const bool breaks = std::min({d.breakForce, d.breakTorque, d.reportForce, d.reportTorque}) < kUnlimited;
    return static_cast<std::uint8_t>((d.limit.on ? kLimited : 0) | (d.motor.on ? kDriven : 0) |
                                     (d.spring.on ? kSprung : 0) | (d.hertz > 0.0f ? kSoft : 0) |
                                     (breaks ? kBreakable : 0) |
                                     (d.collideConnected || d.kind == JointKind::Mouse ? 0 : kKeepsApart));
}

/// Applies a definition to a joint, except kind and bodies.
/// @param axis  JointDefinition::axis with unit length
void take(World& world, std::uint32_t index, const JointDefinition& definition, Vec2 axis) {
    Joint& joint = world.joints.hot[index];
    joint.anchorA = definition.anchorA - world.bodies.pose[joint.bodyA].localCentre;
    joint.anchorB = definition.anchorB - world.bodies.pose[joint.bodyB].localCentre;
    joint.quality = definition.quality;
    joint.flags = static_cast<std::uint8_t>((joint.flags & kStretched) | flagsOf(definition));
    world.joints.definition[index] = definition;
    world.joints.definition[index].axis = axis;
    callFor(world, definition, 1);
    wake(world, joint.bodyA);
    wake(world, joint.bodyB);
}

/// Destroys the gears that use this joint.
void destroyGearsOf(World& world, JointId joint) {
    for (std::uint32_t j = 0; j < world.joints.size(); ++j) {
        const JointDefinition& gear = world.joints.definition[j];
        if (world.joints.hot[j].kind == JointKind::Gear && (gear.jointA == joint || gear.jointB == joint))
            destroyJoint(world, idOfJoint(world, j));
    }
}

}  // namespace

bool keptApart(const World& world, std::uint32_t bodyA, std::uint32_t bodyB) {
    bool kept = false;
    forJointsOf(world, bodyA, [&](std::uint32_t j) {
        const Joint& joint = world.joints.hot[j];
        const std::uint32_t other = joint.bodyA == bodyA ? joint.bodyB : joint.bodyA;
        kept |= other == bodyB && (joint.flags & kKeepsApart) != 0;
    });
    return kept;
}

PushedBodies pushedBodies(const World& world, const Joint& joint) {
    const bool pushesA = isDynamic(world, joint.bodyA) && joint.kind != JointKind::Mouse;
    if (!isDynamic(world, joint.bodyB)) return {kNone, joint.bodyA};
    return {pushesA ? joint.bodyA : kNone, joint.bodyB};
}

void releaseColour(World& world, std::uint32_t index) {
    if (world.work.stale()) return;
    const Joint& joint = world.joints.hot[index];
    const auto [a, b] = pushedBodies(world, joint);
    freeColour(world.work.get(), a, b, joint.colour);
}

void joinIslandsOf(World& world, const Joint& joint) {
    if (joint.awakeIndex == kNone) return;  // a filter, or a joint of a disabled body, which is in no island
    if (isDynamic(world, joint.bodyA) && isDynamic(world, joint.bodyB))
        joinIslands(world, joint.bodyA, joint.bodyB);
}

Result<JointId> createJoint(World& world, const JointDefinition& definition) {
    if (const auto checked = check(world, definition); !checked) return checked.error();
    const std::uint32_t index = takeIndex(world.joints.free, world.joints.hot, world.joints.definition);
    Joint& joint = world.joints.hot[index];
    joint = {.bodyA = definition.a.index,
             .bodyB = definition.b.index,
             .kind = definition.kind,
             .generation = joint.generation + 1};
    joint.nextA = std::exchange(world.bodies.info[joint.bodyA].firstJoint, index);
    joint.nextB = std::exchange(world.bodies.info[joint.bodyB].firstJoint, index);
    take(world, index, definition, normalized(definition.axis));
    addAwakeJoint(world, index);
    joinIslandsOf(world, joint);
    if (!definition.collideConnected) world.filtersStale = true;
    world.newJoints = true;
    return JointId{index, joint.generation};
}

void destroyJoint(World& world, JointId id) {
    if (!mayChange(world, id)) return;
    Joint& joint = world.joints.hot[id.index];
    wake(world, joint.bodyA);
    wake(world, joint.bodyB);
    unlink(world, joint.bodyA, id.index, joint.nextA);
    unlink(world, joint.bodyB, id.index, joint.nextB);
    if ((joint.flags & kKeepsApart) != 0) refreshPairs(world, joint);
    callFor(world, world.joints.definition[id.index], -1);
    releaseColour(world, id.index);
    removeAwakeJoint(world, id.index);
    joint.bodyA = joint.bodyB = kNone;
    world.islandsStale = true;
    world.joints.free.push_back(id.index);
    destroyGearsOf(world, id);
}

Result<Done> setDefinition(World& world, JointId id, const JointDefinition& definition) {
    const auto checked = firstOf(checkAlive("setDefinition", world, id), check(world, definition));
    if (!checked) return checked;
    const JointDefinition& before = definitionOf(world, id);
    if (definition.kind != before.kind || definition.a != before.a || definition.b != before.b ||
        definition.jointA != before.jointA || definition.jointB != before.jointB) {
        return usageError("setDefinition", "the kind, the bodies and the joints of a gear cannot be changed",
                          "destroy the joint and create another");
    }
    Joint& joint = world.joints.hot[id.index];
    const bool rearms = flagsOf(definition) != flagsOf(before);
    const Vec2 axis = definition.axis == before.axis ? before.axis : normalized(definition.axis);
    if (rearms || definition.anchorA != before.anchorA || definition.anchorB != before.anchorB)
        world.work.get().joints.trees.stale = true;
    if (definition.collideConnected != before.collideConnected) {
        world.filtersStale = true;
        refreshPairs(world, joint);
    }
    callFor(world, before, -1);
    take(world, id.index, definition, axis);
    if (joint.colour != kNoColour) joint.flags |= kEdited;  // the joint has been solved in a step
    // An enabled limit, motor or spring starts without an old impulse. A gear stores its error in rows.
    if (rearms && joint.kind != JointKind::Gear) std::fill_n(joint.rows, std::size(joint.rows), 0.0f);
    return Done{};
}

Result<Done> setMotorSpeed(World& world, JointId joint, float speed) {
    if (alive(world, joint) && !jointType(definitionOf(world, joint).kind).hasMotor) {
        return usageError("setMotorSpeed", "this kind of joint has no motor",
                          "use a distance, revolute, prismatic, wheel or motor joint");
    }
    return change(world, joint, [&](JointDefinition& definition) { definition.motor.speed = speed; });
}

Result<Done> setTarget(World& world, JointId joint, WorldPosition target) {
    if (alive(world, joint) && definitionOf(world, joint).kind != JointKind::Mouse)
        return usageError("setTarget", "expected a mouse joint, found another kind", "pass a mouse joint");
    return change(world, joint, [&](JointDefinition& definition) { definition.target = target; });
}

}  // namespace plumb::physics
