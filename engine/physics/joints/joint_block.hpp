#pragma once

#include <cstdint>

#include "physics/lanes.hpp"
#include "physics/softness.hpp"

namespace plumb::physics {

// A joint is composed of three constraints: a point of A that coincides with a point of B, a length along a
// direction, an angle. A "value" (a length or an angle) can be held, driven by a motor, and limited.

/// Soft constraint parameters of a joint ("grip"): impulse -= mass * (take * speed + pull * error) + give *
/// impulse.
struct Grip {
    float take = 0.0f;
    float pull = 0.0f;  ///< 1/s
    float give = 1.0f;
};

inline Grip gripOf(const Softness& soft) {
    return {soft.massScale, soft.massScale * soft.biasRate, soft.impulseScale};
}

/// The same for eight joints. Springs keep them in the relax pass; other joints are rigid there.
struct GripLanes {
    float take[kLanes];
    float pull[kLanes];
    float give[kLanes];
    float springs[kLanes];  ///< 1 or 0
    float maximum[kLanes];  ///< N s or N m s: maximum impulse per substep
};

/// The two bodies of eight joints of one color.
struct JointBodies {
    std::uint32_t a[kLanes];  ///< bytes: of their slots, from the first
    std::uint32_t b[kLanes];
    float inverseInertiaA[kLanes];
    float inverseInertiaB[kLanes];
    std::uint32_t own[kLanes];  ///< of the only body that a one-sided joint moves
    float ownIsA[kLanes];       ///< 1 if that is A, else 0
};

/// Two anchors, with the arms of the start of the step.
struct AnchorLanes {
    VecLanes armA;  ///< m, world, from the center of mass
    VecLanes armB;
    VecLanes apart;  ///< m: from A's anchor to B's, at the start of the step
};

/// Constraints on a value: what holds it, a motor, and two limits.
struct RowLanes {
    std::int32_t uses;       ///< bits of RowUse, of all lanes together
    float value[kLanes];     ///< m or rad, as of the last biased pass
    float rest[kLanes];      ///< value at which it is held
    float speed[kLanes];     ///< m/s or rad/s: of the motor
    float maxMotor[kLanes];  ///< N s or N m s: maximum impulse per substep
    float lower[kLanes];
    float upper[kLanes];
    GripLanes grip;
    float holdImpulse[kLanes];
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
    VecLanes impulse;     ///< N s, on B
    float turnA[kLanes];  ///< N m s: after a biased pass, torque of the impulse; after a relax pass, its
                          ///< correction along the current arms
    float turnB[kLanes];
};

/// Eight joints that constrain a point, possibly softly or with limited force, and the angle.
struct HingeBlock : PointBlock {
    static constexpr bool kHasAngle = true;

    GripLanes grip;
    VecLanes apart;       ///< m: from A's anchor to B's, as of the last biased pass
    float angle[kLanes];  ///< rad, at the start of the step
    RowLanes turning;
};

/// Correction of impulses whose directions rotate with the bodies: along the current directions, minus what
/// was applied.
struct CarryLanes {
    VecLanes impulse;     ///< N s
    float turnA[kLanes];  ///< N m s
    float turnB[kLanes];
};

/// Eight joints that act along the line through their anchors.
struct RodBlock {
    static constexpr bool kSlides = false;

    JointBodies bodies;
    AnchorLanes anchors;
    CarryLanes carry;
    RowLanes along;
};

/// Eight joints that let B slide along an axis of A.
struct SliderBlock : RodBlock {
    static constexpr bool kSlides = true;

    VecLanes axis;                ///< at the start of the step
    float angle[kLanes];          ///< rad, at the start of the step, relative to where it is held
    float holdsAngle[kLanes];     ///< 1 or 0
    float acrossImpulse[kLanes];  ///< N s
    float angleImpulse[kLanes];   ///< N m s
    std::int32_t spins;           ///< nonzero if some lane has a rotational motor
    float spin[kLanes];           ///< rad/s: target speed of that motor
    float maxSpin[kLanes];        ///< N m s: maximum impulse per substep
    float spinImpulse[kLanes];
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
