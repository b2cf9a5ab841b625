#pragma once

#include <cstdint>

#include "physics/solver/lanes.hpp"

namespace plumb::physics {

// Joints are made of three parts: a point of A that is a point of B, a length along a direction, an angle.
// What is measured of a length or an angle (a "value") can be held, driven by a motor, and limited.

/// How hard an error is answered: impulse -= mass * (take * speed + pull * error) + give * impulse.
struct Grip {
    float take = 0.0f;
    float pull = 0.0f;  ///< 1/s
    float give = 1.0f;
};

/// The same of eight joints. What springs does so in the relax pass too; what does not is rigid there.
struct GripLanes {
    float take[kLanes];
    float pull[kLanes];
    float give[kLanes];
    float springs[kLanes];  ///< 1 or 0
    float most[kLanes];     ///< N s or N m s: as much as it can give
};

/// The two bodies of eight joints of one colour.
struct JointBodies {
    std::int32_t a[kLanes];  ///< slots
    std::int32_t b[kLanes];
    float inverseInertiaA[kLanes];
    float inverseInertiaB[kLanes];
    std::int32_t own[kLanes];  ///< of joints with one body that can be pushed: that one
    float ownIsA[kLanes];      ///< 1 or 0
};

/// Two anchors. Arms are those of the start of the step.
struct AnchorLanes {
    float armAX[kLanes];  ///< m, world, from the centre of mass
    float armAY[kLanes];
    float armBX[kLanes];
    float armBY[kLanes];
    float apartX[kLanes];  ///< m: from A's anchor to B's, at the start of the step
    float apartY[kLanes];
};

/// The rows of a value: what holds it, a motor, and two limits.
struct RowLanes {
    std::int32_t uses;        ///< bits of RowUse, of any lane
    float value[kLanes];      ///< m or rad, when errors were pushed out last
    float rest[kLanes];       ///< where it is held
    float speed[kLanes];      ///< m/s or rad/s: of the motor
    float mostMotor[kLanes];  ///< N s or N m s
    float lower[kLanes];
    float upper[kLanes];
    GripLanes grip;
    float holdImpulse[kLanes];
    float motorImpulse[kLanes];
    float lowerImpulse[kLanes];
    float upperImpulse[kLanes];
};

enum RowUse : std::int32_t { kHolds = 1, kDrives = 2, kLimits = 4 };

/// Eight plain hinges.
struct PointBlock {
    JointBodies bodies;
    AnchorLanes anchors;
    float impulseX[kLanes];  ///< N s, on B
    float impulseY[kLanes];
    float turnA[kLanes];  ///< N m s: after a push, of the impulse; after relaxing, what it now lacks
    float turnB[kLanes];
};

/// Eight joints that hold a point, softly or weakly perhaps, and do something to the angle.
struct HingeBlock {
    PointBlock point;
    GripLanes grip;
    float apartX[kLanes];  ///< m: from A's anchor to B's, when errors were pushed out last
    float apartY[kLanes];
    float angle[kLanes];  ///< rad, at the start of the step
    RowLanes turning;
};

/// What impulses along directions that turn with the bodies lack of those along the directions of now.
struct CarryLanes {
    float x[kLanes];  ///< N s
    float y[kLanes];
    float turnA[kLanes];  ///< N m s
    float turnB[kLanes];
};

/// Eight joints that act along the line through their anchors.
struct RodBlock {
    JointBodies bodies;
    AnchorLanes anchors;
    CarryLanes carry;
    RowLanes along;
};

/// Eight joints that let B slide along an axis of A.
struct SliderBlock {
    JointBodies bodies;
    AnchorLanes anchors;
    CarryLanes carry;
    float axisX[kLanes];  ///< at the start of the step
    float axisY[kLanes];
    float angle[kLanes];          ///< rad, at the start of the step, less where it is held
    float holdsAngle[kLanes];     ///< 1 or 0
    float acrossImpulse[kLanes];  ///< N s
    float angleImpulse[kLanes];   ///< N m s
    std::int32_t spins;           ///< some lane has a motor that turns
    float spin[kLanes];           ///< rad/s: of that motor
    float mostSpin[kLanes];       ///< N m s
    float spinImpulse[kLanes];
    RowLanes along;
};

enum JointBlockKind : std::int32_t {
    kPointBlocks,
    kHingeBlocks,
    kRodBlocks,
    kSliderBlocks,
    kJointBlockKinds
};

/// Which joints are in a block: indices into World::joints; repeats the last one in empty lanes.
struct JointLanes {
    std::int32_t joint[kLanes];
    std::int32_t count;
};

/// What a pass over joints needs to know.
struct JointPass {
    Grip rigid;                ///< of what is as stiff as substeps allow
    float substepRate = 0.0f;  ///< 1/s
    float pushSpeed = 0.0f;    ///< m/s or rad/s: no faster is closed what is open
    bool first = true;         ///< of the passes of this substep
};

}  // namespace plumb::physics
