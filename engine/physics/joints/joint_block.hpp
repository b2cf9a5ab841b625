#pragma once

#include <cstdint>

#include "physics/lanes.hpp"
#include "physics/softness.hpp"

namespace plumb::physics {

// A joint is composed of three constraints: a point of A that coincides with a point of B, a length along a
// direction, an angle. A "value" (a length or an angle) can be held, driven by a motor, and limited.

/// Soft constraint parameters of a joint ("grip"):
/// impulse -= mass * (speedScale * speed + errorRate * error) + impulseScale * impulse.
struct Grip {
    float speedScale = 0.0f;    ///< ratio
    float errorRate = 0.0f;     ///< 1/s
    float impulseScale = 1.0f;  ///< ratio
};

inline Grip gripOf(const Softness& soft) {
    return {soft.massScale, soft.massScale * soft.biasRate, soft.impulseScale};
}

/// The Grip of eight joints. In the relax pass of a substep only springs use it; other joints are rigid.
struct GripLanes {
    float speedScale[kLanes];
    float errorRate[kLanes];
    float impulseScale[kLanes];
    float springs[kLanes];  ///< 1 for a spring, else 0
    float maximum[kLanes];  ///< N s or N m s: maximum impulse per substep
};

/// The two bodies of eight joints of one color.
struct JointBodies {
    std::uint32_t a[kLanes];  ///< byte offset of the body's slot from the first slot
    std::uint32_t b[kLanes];
    float inverseInertiaA[kLanes];
    float inverseInertiaB[kLanes];
    std::uint32_t own[kLanes];  ///< byte offset of the only body that a one-sided joint moves
    float ownIsA[kLanes];       ///< 1 if that body is A, else 0
};

/// The anchors of eight joints at the start of the step.
struct AnchorLanes {
    VecLanes armA;  ///< m, world: from the center of mass of A to its anchor
    VecLanes armB;
    VecLanes apart;  ///< m: from A's anchor to B's, at the start of the step
};

/// Constraints on a value: a rigid or soft constraint that holds it, a motor, and two limits.
struct RowLanes {
    std::int32_t uses;          ///< RowUse bits of the constraints that at least one lane uses
    float value[kLanes];        ///< m or rad, as of the last biased pass
    float rest[kLanes];         ///< m or rad: value at which it is held
    float speed[kLanes];        ///< m/s or rad/s: target speed of the motor
    float maxMotor[kLanes];     ///< N s or N m s: maximum motor impulse per substep
    float lower[kLanes];        ///< m or rad: lower limit
    float upper[kLanes];        ///< m or rad: upper limit
    float returnSpeed[kLanes];  ///< m/s or rad/s: maximum speed at which a value returns to its limits
    GripLanes grip;
    float holdImpulse[kLanes];  ///< N s or N m s, like the next three
    float motorImpulse[kLanes];
    float lowerImpulse[kLanes];
    float upperImpulse[kLanes];
};

enum RowUse : std::int32_t { kHolds = 1, kDrives = 2, kLimits = 4 };

/// Eight hinges without limit, motor and spring.
struct PointBlock {
    static constexpr bool kHasAngle = false;

    JointBodies bodies;
    AnchorLanes anchors;
    VecLanes impulse;         ///< N s, on B
    float rotationA[kLanes];  ///< N m s: after a biased pass, angular part of the impulse; after a relax
                              ///< pass, the correction of that part for the current arms
    float rotationB[kLanes];
};

/// Eight joints that constrain a point, possibly softly or with limited force, and the angle.
struct HingeBlock : PointBlock {
    static constexpr bool kHasAngle = true;

    GripLanes grip;
    VecLanes apart;       ///< m: from A's anchor to B's, as of the last biased pass
    float angle[kLanes];  ///< rad, at the start of the step
    RowLanes turning;     ///< constraints on the angle
};

/// Correction of impulses whose directions rotate with the bodies: the impulse along the current directions
/// minus the applied one.
struct CarryLanes {
    VecLanes impulse;         ///< N s
    float rotationA[kLanes];  ///< N m s
    float rotationB[kLanes];
};

/// Eight joints that act along the line through their anchors.
struct RodBlock {
    static constexpr bool kSlides = false;  ///< false: a rod between two anchors; true: see SliderBlock

    JointBodies bodies;
    AnchorLanes anchors;
    CarryLanes carry;
    RowLanes along;  ///< constraints on the length along that line
};

/// Eight joints that let B slide along an axis of A.
struct SliderBlock : RodBlock {
    static constexpr bool kSlides = true;

    VecLanes axis;                ///< at the start of the step
    float angle[kLanes];          ///< rad, at the start of the step, minus the angle at which it is held
    float holdsAngle[kLanes];     ///< 1 if the angle is held, else 0
    float acrossImpulse[kLanes];  ///< N s: across the axis
    float angleImpulse[kLanes];   ///< N m s
    std::int32_t spins;           ///< nonzero if some lane has a rotational motor
    float spin[kLanes];           ///< rad/s: target speed of the rotational motor
    float maxSpin[kLanes];        ///< N m s: maximum impulse per substep
    float spinImpulse[kLanes];    ///< N m s
};

enum JointBlockKind : std::int32_t {
    kPointBlocks,
    kHingeBlocks,
    kRodBlocks,
    kSliderBlocks,
    kJointBlockKinds
};

/// Parameters of a pass over joints.
struct JointPass {
    Grip rigid;  ///< soft constraint parameters of joints that are as stiff as the substeps allow
    float substepRate = 0.0f;  ///< 1/s
    float pushSpeed = 0.0f;    ///< m/s or rad/s: maximum speed at which joint errors are closed
    bool first = true;         ///< first iteration of this pass in the substep
};

}  // namespace plumb::physics
