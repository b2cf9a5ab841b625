#include "physics/joints/joint_types.hpp"

#include <algorithm>

#include "physics/tuning.hpp"

namespace plumb::physics {

JointView viewOf(const World& world, std::uint32_t index, const JointTiming& timing) {
    const Joint& joint = world.joints.hot[index];
    const BodyPose &a = world.bodies.pose[joint.bodyA], &b = world.bodies.pose[joint.bodyB];
    return {
        world, joint, world.joints.definition[index], timing, a.rotation, b.rotation, b.centre - a.centre};
}

JointParts anchorsOf(const JointView& view) {
    JointParts parts;
    parts.armA = rotate(view.rotationA, view.joint.anchorA);
    parts.armB = rotate(view.rotationB, view.joint.anchorB);
    parts.apart = view.between + (parts.armB - parts.armA);
    parts.grip = view.timing.rigid;
    return parts;
}

namespace {

// Constraints that several kinds of joints use.

/// Returns the impulse of a force or torque in a substep, N s or N m s.
float impulseOf(float force, const JointView& view) { return std::min(force * view.timing.h, kNoLimit); }

/// Soft constraint parameters of a spring with a given frequency (1/s) and damping ratio, on the effective
/// mass of its joint, for a substep of h (s). Frequency, damping and static sag are exact as long as the
/// spring is much slower than the substeps.
Grip springGrip(float hertz, float dampingRatio, float h) {
    // Above half a radian per substep the implicit (soft) spring is used: it is unconditionally stable.
    const float phase = kTau * hertz * h;
    if (phase > 0.5f) return gripOf(softness(hertz, dampingRatio, h));
    // Explicit spring: its velocity decays as that of the damped oscillator, and its static sag is exact.
    // Without damping this is symplectic Euler, which conserves energy.
    const float kept = exponential(-2.0f * dampingRatio * phase);
    return {1.0f - kept, phase * phase * kept / h, kept};
}

/// Sets `grip` to JointTiming::rigid, or to a spring if the joint's hertz is below JointTiming::stiffest.
/// @return true for a spring
bool ownGrip(const JointView& view, Grip& grip) {
    const float hertz = view.definition.hertz;
    const bool springs = hertz > 0.0f && hertz < view.timing.stiffest;
    grip = springs ? springGrip(hertz, view.definition.dampingRatio, view.timing.h) : view.timing.rigid;
    return springs;
}

/// Returns motor, limits and spring of the definition; a spring holds the value at its rest value.
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
        value.returnSpeed = returnSpeedOf(view);
        value.lower = limitOf(view).lower;
        value.upper = limitOf(view).upper;
    }
    return value;
}

// The constraints of each kind of joint.

template <JointBlockKind kKind>
JointBlockKind always(std::uint8_t) {
    return kKind;
}

JointParts distance(const JointView& view) {
    JointParts parts = anchorsOf(view);
    parts.value = valueParts(view);
    parts.value.rest = view.definition.length;
    if (!view.definition.spring.on && !view.definition.limit.on && !view.definition.motor.on) {
        parts.value.held = true;
        parts.value.springs = ownGrip(view, parts.value.grip);
    }
    return parts;
}

/// Returns point blocks for a plain hinge, hinge blocks for one with a limit, a motor or a spring.
JointBlockKind hinge(std::uint8_t flags) {
    return (flags & (kLimited | kDriven | kSprung | kSoft)) != 0 ? kHingeBlocks : kPointBlocks;
}

JointParts revolute(const JointView& view) {
    JointParts parts = anchorsOf(view);
    if (hinge(view.joint.flags) == kPointBlocks) return parts;  // avoids a read of the definition
    parts.springs = ownGrip(view, parts.grip);
    parts.value = valueParts(view);
    parts.angle = angleOf(view);
    return parts;
}

JointParts prismatic(const JointView& view) {
    JointParts parts = anchorsOf(view);
    parts.axis = rotate(view.rotationA, view.definition.axis);
    parts.value = valueParts(view);
    parts.angle = angleOf(view);
    parts.holdsAngle = true;
    return parts;
}

JointParts weld(const JointView& view) {
    JointParts parts = anchorsOf(view);
    parts.springs = ownGrip(view, parts.grip);
    parts.angle = angleOf(view);
    parts.value.held = true;
    parts.value.springs = parts.springs;
    parts.value.grip = parts.grip;
    const JointSpring& spring = view.definition.spring;
    parts.holdsAngle = !spring.on && !parts.springs;
    if (!spring.on) return parts;
    parts.value.springs = spring.hertz < view.timing.stiffest;
    parts.value.grip = parts.value.springs ? springGrip(spring.hertz, spring.dampingRatio, view.timing.h)
                                           : view.timing.rigid;
    return parts;
}

JointParts wheel(const JointView& view) {
    JointParts parts = anchorsOf(view);
    parts.axis = rotate(view.rotationA, view.definition.axis);
    parts.value = valueParts(view);
    parts.spin = parts.value.speed;
    parts.maxSpin = parts.value.maxMotor;
    parts.value.driven = false;  // the motor drives the rotation, not the translation
    return parts;
}

// Mouse and motor joints: damped springs of limited force. Source: E. Catto, "Soft Constraints", GDC 2011.

JointParts mouse(const JointView& view) {
    const JointSpring& spring = view.definition.spring;
    const Bodies& bodies = view.world.bodies;
    JointParts parts = anchorsOf(view);
    parts.armA = {};
    parts.apart = (bodies.pose[view.joint.bodyB].centre - view.definition.target) + parts.armB;
    parts.grip = springGrip(spring.on ? spring.hertz : kDefaultHertz, spring.on ? spring.dampingRatio : 1.0f,
                            view.timing.h);
    parts.springs = true;
    const float massB = bodies.mass[view.joint.bodyB].mass;
    parts.maximum = impulseOf(std::min(view.definition.maxForce, kMousePull * massB), view);
    return parts;
}

JointParts motor(const JointView& view) {
    const JointDefinition& definition = view.definition;
    JointParts parts = anchorsOf(view);
    // Soft in both passes: the relax pass must not undo the correction by the limited force.
    parts.springs = true;
    parts.maximum = impulseOf(definition.maxForce, view);
    parts.angle = angleOf(view);
    if (definition.motor.on) {
        parts.grip = {1.0f, kSteering, 0.0f};
        parts.apart = (-1.0f / kSteering) * rotate(view.rotationA, definition.velocity);
        parts.value.driven = true;
        parts.value.speed = definition.motor.speed;
        parts.value.maxMotor = impulseOf(definition.maxTorque, view);
        return parts;
    }
    const Vec2 offset = rotate(view.rotationA, definition.offset);
    parts.armA += offset;
    parts.apart -= offset;
    const bool own = definition.hertz > 0.0f;
    parts.grip = springGrip(own ? definition.hertz : kDefaultHertz, own ? definition.dampingRatio : 1.0f,
                            view.timing.h);
    if (!own) {  // no spring is defined: the error closes no faster than in other joints
        const float most =
            kJointPushing * view.world.settings.pushSpeed * parts.grip.speedScale / parts.grip.errorRate;
        parts.apart *= most / std::max(length(parts.apart), most);
        parts.angle = std::clamp(parts.angle, -most, most);
    }
    parts.value.held = true;
    parts.value.springs = true;
    parts.value.grip = parts.grip;
    parts.value.maximum = impulseOf(definition.maxTorque, view);
    return parts;
}

/// Adds the Jacobian of a hinge angle or slider translation, times `ratio`, to the constraint.
void addCoordinate(const World& world, std::uint32_t index, float ratio, NBodyConstraint& constraint) {
    const Joint& joint = world.joints.hot[index];
    if (joint.kind != JointKind::Prismatic) {
        constraint.add({joint.bodyA, 0.0f, 0.0f, -ratio});
        constraint.add({joint.bodyB, 0.0f, 0.0f, ratio});
        return;
    }
    const BodyPose& a = world.bodies.pose[joint.bodyA];
    const BodyPose& b = world.bodies.pose[joint.bodyB];
    const Vec2 axis = ratio * rotate(a.rotation, world.joints.definition[index].axis);
    const Vec2 armB = rotate(b.rotation, joint.anchorB), armA = (b.centre - a.centre) + armB;
    constraint.add({joint.bodyA, -axis.x, -axis.y, -cross(armA, axis)});
    constraint.add({joint.bodyB, axis.x, axis.y, cross(armB, axis)});
}

/// The error accumulates over all steps (Joint::rows[1]): angles are not limited to one revolution.
NBodyConstraint gear(const World& world, const Joint& joint, const JointDefinition& definition) {
    NBodyConstraint constraint;
    addCoordinate(world, definition.jointA.index, 1.0f, constraint);
    addCoordinate(world, definition.jointB.index, definition.ratio, constraint);
    constraint.error = joint.rows[1];
    return constraint;
}

/// Adds the Jacobian of one side of the rope.
/// @return the length of that side times `ratio`
float addSide(const World& world, std::uint32_t body, Vec2 anchor, Vec2 ground, float ratio,
              NBodyConstraint& constraint) {
    const BodyPose& pose = world.bodies.pose[body];
    const Vec2 arm = rotate(pose.rotation, anchor);
    const Vec2 rope = (pose.centre - WorldPosition{ground}) + arm;
    const Vec2 along = ratio * normalized(rope);
    constraint.add({body, along.x, along.y, cross(arm, along)});
    return ratio * length(rope);
}

NBodyConstraint pulley(const World& world, const Joint& joint, const JointDefinition& definition) {
    NBodyConstraint constraint;
    const float a = addSide(world, joint.bodyA, joint.anchorA, definition.groundA, 1.0f, constraint);
    const float b =
        addSide(world, joint.bodyB, joint.anchorB, definition.groundB, definition.ratio, constraint);
    constraint.error = a + b - definition.length;
    return constraint;
}

/// The joint types, in the order of JointKind.
constexpr std::array<JointType, static_cast<std::size_t>(JointKind::Count)> kJointTypes{{
    {always<kRodBlocks>, distance, nullptr, true},
    {hinge, revolute, nullptr, true},
    {always<kSliderBlocks>, prismatic, nullptr, true},
    {always<kHingeBlocks>, weld},
    {always<kSliderBlocks>, wheel, nullptr, true},
    {always<kHingeBlocks>, mouse},
    {always<kHingeBlocks>, motor, nullptr, true},
    {nullptr, nullptr, gear},
    {nullptr, nullptr, pulley},
    {always<kRodBlocks>, anchorsOf},  // filter joints are never solved: see addAwakeJoint()
}};

}  // namespace

const JointType& jointType(JointKind kind) { return kJointTypes[static_cast<std::size_t>(kind)]; }

}  // namespace plumb::physics
