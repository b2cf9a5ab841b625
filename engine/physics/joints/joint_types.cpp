#include "physics/joints/joint_types.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/solver/softness.hpp"

namespace plumb::physics {

#define PLUMB_DECLARE(name) extern const JointType k##name##Joint;
PLUMB_JOINTS(PLUMB_DECLARE)

namespace {

#define PLUMB_ROW(name) &k##name##Joint,
constexpr std::array<const JointType*, static_cast<std::size_t>(JointKind::Count)> kJointTypes{
    PLUMB_JOINTS(PLUMB_ROW)};

Grip gripOf(const Softness& soft) {
    return {soft.massScale, soft.massScale * soft.biasRate, soft.impulseScale};
}

}  // namespace

const JointType& jointType(JointKind kind) { return *kJointTypes[static_cast<std::size_t>(kind)]; }

JointParts anchorsOf(const JointView& view) {
    JointParts parts;
    parts.armA = rotate(view.turnA, view.joint.anchorA);
    parts.armB = rotate(view.turnB, view.joint.anchorB);
    parts.apart = view.between + (parts.armB - parts.armA);
    parts.grip = view.timing.rigid;
    return parts;
}

float angleOf(const JointView& view) {
    const float angle = angleOf(between(view.turnA, view.turnB)) - view.definition.referenceAngle;
    return angle - kTau * std::floor((angle + kPi) / kTau);
}

Grip springGrip(float hertz, float dampingRatio, float h) {
    // Above half a radian per substep the implicit (soft) spring is used: it is unconditionally stable.
    const float turn = kTau * hertz * h;
    if (turn > 0.5f) return gripOf(softness(hertz, dampingRatio, h));
    // Explicit spring: its velocity decays as that of the damped oscillator, and its static sag is exact.
    // Without damping this is symplectic Euler, which conserves energy.
    const float kept = exponential(-2.0f * dampingRatio * turn);
    return {1.0f - kept, turn * turn * kept / h, kept};
}

bool ownGrip(const JointView& view, Grip& grip) {
    const float hertz = view.definition.hertz;
    const bool springs = hertz > 0.0f && hertz < view.timing.stiffest;
    grip = springs ? springGrip(hertz, view.definition.dampingRatio, view.timing.h) : view.timing.rigid;
    return springs;
}

ValueParts valueParts(const JointView& view) {
    const JointDefinition& definition = view.definition;
    ValueParts value;
    if (definition.spring.on) {
        value.held = value.springs = true;
        value.grip = springGrip(definition.spring.hertz, definition.spring.dampingRatio, view.timing.h);
        value.rest = definition.spring.rest;
    }
    if (definition.motor.on) {
        value.driven = true;
        value.speed = definition.motor.speed;
        value.maxMotor = std::min(definition.motor.maxForce * view.timing.h, kNoLimit);
    }
    if (definition.limit.on) {
        value.limited = true;
        value.lower = definition.limit.lower;
        value.upper = definition.limit.upper;
    }
    return value;
}

}  // namespace plumb::physics
