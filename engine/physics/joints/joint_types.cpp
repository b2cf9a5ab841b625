#include "physics/joints/joint_types.hpp"

#include <algorithm>
#include <cmath>

#include "physics/solver/passes.hpp"

namespace plumb::physics {

JointView viewOf(const World& world, std::uint32_t index, const JointTiming& timing) {
    const Joint& joint = world.joints.hot[index];
    const JointDefinition& definition = world.joints.definition[index];
    const BodyPose &a = world.bodies.pose[joint.bodyA], &b = world.bodies.pose[joint.bodyB];
    JointView view{joint,      definition,          timing, a.rotation,
                   b.rotation, b.centre - a.centre, {},     world.bodies.mass[joint.bodyB].mass};
    if (joint.kind == JointKind::Mouse) view.toTarget = b.centre - definition.target;
    return view;
}

float impulseOf(float force, const JointView& view) { return std::min(force * view.timing.h, kNoLimit); }

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
        value.maxMotor = impulseOf(definition.motor.maxForce, view);
    }
    if (definition.limit.on) {
        value.limited = true;
        value.lower = definition.limit.lower;
        value.upper = definition.limit.upper;
    }
    return value;
}

}  // namespace plumb::physics
