#pragma once

#include "physics/joints/joint_block.hpp"
#include "physics/tuning.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

struct JointTiming {
    float h = 0.0f;         ///< s: length of a substep
    float stiffest = 0.0f;  ///< 1/s: a spring at or above this frequency counts as rigid
    Grip rigid;             ///< soft constraint parameters of a joint that is as stiff as the substeps allow
};

/// A joint and the poses of its bodies at the start of the step.
struct JointView {
    const World& world;
    const Joint& joint;
    const JointDefinition& definition;
    const JointTiming& timing;
    Rot rotationA;
    Rot rotationB;
    Vec2 between;  ///< m: from A's center of mass to B's
};

/// Larger than any impulse: stands for "unlimited".
inline constexpr float kNoLimit = 1.0e18f;

/// Constraints on a length or an angle: held at a value, driven by a motor, limited.
struct ValueParts {
    bool held = false;
    bool springs = false;      ///< held by a spring instead of rigidly
    Grip grip;                 ///< soft constraint parameters with which it is held
    float rest = 0.0f;         ///< m or rad: the value at which it is held
    float maximum = kNoLimit;  ///< N s or N m s: maximum impulse per substep
    bool driven = false;
    float speed = 0.0f;        ///< m/s or rad/s: target speed of the motor
    float maxMotor = 0.0f;     ///< N s or N m s: maximum motor impulse per substep
    float returnSpeed = 0.0f;  ///< m/s or rad/s: see returnSpeedOf()
    bool limited = false;
    float lower = -kNoLimit;  ///< m or rad: lower limit
    float upper = kNoLimit;   ///< m or rad: upper limit
};

/// A joint in terms of the solver's constraints. Its block kind decides which of them apply.
struct JointParts {
    Vec2 armA;  ///< m, world: from the center of mass of A to its anchor
    Vec2 armB;
    Vec2 apart;                ///< m: from A's anchor to B's
    Grip grip;                 ///< soft constraint parameters of the point constraint
    bool springs = false;      ///< the point constraint is a spring
    float maximum = kNoLimit;  ///< N s: maximum impulse per substep
    float angle = 0.0f;        ///< rad: rotation of B relative to A, minus the reference angle
    ValueParts value;          ///< constraints on the angle (hinges) or the length (rods, sliders)
    Vec2 axis;                 ///< world: sliding axis
    bool holdsAngle = false;   ///< true: holds the angle rigidly at 0
    float spin = 0.0f;         ///< rad/s: target speed of a slider's rotational motor (wheel)
    float maxSpin = 0.0f;      ///< N m s: maximum impulse of that motor per substep
};

/// Jacobian of a multi-body constraint with respect to one body.
struct NBodyJacobian {
    std::uint32_t body = 0;
    float x = 0.0f;  ///< derivative with respect to the body's position
    float y = 0.0f;
    float angle = 0.0f;  ///< derivative with respect to the body's angle
};

/// Constraint that keeps a sum over up to four bodies at 0: gears and pulleys. They are rare, so they are
/// solved one by one. Jacobians are those of the start of the step.
struct NBodyConstraint {
    NBodyJacobian ends[4];
    std::int32_t count = 0;        ///< number of ends in use
    std::int32_t reported = 0;     ///< the end whose force jointForce() reports
    float error = 0.0f;            ///< value of the sum at the start of the step
    std::int32_t slots[4] = {};    ///< per end: slot of its body in the solver
    float inverseInertia[4] = {};  ///< per end, 1/(kg m2)
    float mass = 0.0f;             ///< effective mass of the constraint
    float impulse = 0.0f;          ///< accumulated impulse of a substep
    std::uint32_t joint = 0;       ///< index of the joint
    std::uint8_t group = 0;        ///< index in Workspace::groups

    void add(const NBodyJacobian& end) { ends[count++] = end; }
};

/// Properties of one kind of joint: an entry of the table in joint_types.cpp.
struct JointType {
    JointBlockKind (*block)(std::uint8_t flags);  ///< block layout, by bits of JointFlag
    JointParts (*parts)(const JointView& view);
    /// Replaces `block` and `parts` for joints that are not defined by two anchors (gears, pulleys).
    NBodyConstraint (*constraint)(const World& world, const Joint& joint,
                                  const JointDefinition& definition) = nullptr;
    bool hasMotor = false;  ///< JointDefinition::motor has an effect
};

const JointType& jointType(JointKind kind);

/// Returns a joint with the current poses of its bodies. The view refers to `timing`.
JointView viewOf(const World& world, std::uint32_t joint, const JointTiming& timing);

/// Returns the arms and the separation of both anchors in world space.
JointParts anchorsOf(const JointView& view);
/// A further JointFlag: the joint has had a gap since it was created, its definition was changed or one of
/// its bodies was teleported. Closing the gap may do work, as shortening a rope does.
inline constexpr std::uint8_t kEdited = 128;

/// Returns the limits of a joint. Those of a hinge exclude kLimitSeam at least.
inline JointLimit limitOf(const JointView& view) {
    JointLimit limit = view.definition.limit;
    if (view.joint.kind != JointKind::Revolute) return limit;
    const float middle = 0.5f * (limit.lower + limit.upper), half = kPi - 0.5f * kLimitSeam;
    limit.lower = std::max(limit.lower, middle - half);
    limit.upper = std::min(limit.upper, middle + half);
    return limit;
}
/// Returns the maximum speed (m/s or rad/s) at which a value returns to its limits: that of joint errors. If
/// limits of hinges were changed, that of overlaps: when chains curl faster, they keep kinetic energy.
inline float returnSpeedOf(const JointView& view) {
    const bool isChanged = view.joint.kind == JointKind::Revolute && (view.joint.flags & kEdited) != 0;
    return (isChanged ? 1.0f : kJointPushing) * view.world.settings.pushSpeed;
}
/// Returns the rotation of B relative to A, minus the reference angle (rad): within pi of 0, or of the middle
/// of a hinge's limits, so that beyond them the nearer one counts.
inline float angleOf(const JointView& view) {
    const JointLimit& limit = view.definition.limit;
    const bool isLimited = limit.on && view.joint.kind == JointKind::Revolute;
    const float lowest = isLimited ? 0.5f * (limit.lower + limit.upper) - kPi : -kPi;
    const float angle = angleOf(between(view.rotationA, view.rotationB)) - view.definition.referenceAngle;
    return angle - kTau * std::floor((angle - lowest) / kTau);
}

}  // namespace plumb::physics
