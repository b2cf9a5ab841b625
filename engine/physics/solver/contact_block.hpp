#pragma once

#include <cstddef>
#include <cstdint>

#include "physics/lanes.hpp"
#include "physics/softness.hpp"

namespace plumb::physics {

/// Indices of the rows of four floats in a Contact, for code that reads eight contacts at once.
enum ContactRow {
    kSurfaceRow = 1,
    kNormalRow = 2,
    kImpulseRow = 3,
    kRotationRow = 4,
    kAnchorsRow = 5,
    kRoundRow = 7,
    kContactRows = 8
};

/// Body A or B of eight contacts, if bodies can rotate. Levers are cross products of arms and directions.
struct RotatingSide {
    static constexpr bool kFixed = false;
    std::int32_t slot[kLanes];
    float inverseInertia[kLanes];
    float lever[2][kLanes];  ///< m: lever of the normal, by point
    float turn[kLanes];      ///< m: dot(arm, normal), of the part of the arm that rotates
    float slide[kLanes];     ///< m: dot(arm, normal): lever of friction
};

/// Body A or B of eight contacts in a step without rotation: no levers.
struct SideWithoutRotation {
    static constexpr bool kFixed = false;
    std::uint32_t offset[kLanes];  ///< bytes: offset of its state
    float inverseMass[kLanes];
};

/// Body A of eight contacts, if static or kinematic.
template <std::size_t kPoints>
struct FixedSide {
    static constexpr bool kFixed = true;
    float approach[kPoints][kLanes];  ///< m/s: velocity of its surface along the normal, by point
};

/// One point of each of eight contacts.
struct ContactBlockPoint {
    float separation[kLanes];  ///< m, at the start of the step
    float gap[kLanes];         ///< m: current separation
    float mass[kLanes];        ///< kg: effective mass along the normal
    float impulse[kLanes];     ///< N s
};

/// Eight contacts of one color, one per SIMD lane: no dynamic body appears twice. Friction of both points
/// acts on one line, so it is a single constraint at their midpoint. Source: E. Catto, "Iterative Dynamics
/// with Temporal Coherence", GDC 2005.
template <class SideA, class SideB, std::size_t kPointCount>
struct ContactBlockOf {
    static constexpr int kPoints = int{kPointCount};

    SideA a;
    SideB b;
    VecLanes normal;
    ContactBlockPoint points[kPointCount];
    float friction[kLanes];    ///< this and the following: used only with friction
    float slideSpeed[kLanes];  ///< m/s: speed of the surfaces (conveyors, kinematic bodies)
    float slideMass[kLanes];
    float slideImpulse[kLanes];
};

/// State of the bodies of a step, by solver slot, in flat arrays without other data. Eight idle slots at the
/// end are for SIMD lanes without a body.
struct SolverBodies {
    static constexpr bool kRotate = true;
    using TwoBlock = ContactBlockOf<RotatingSide, RotatingSide, 2>;  ///< two dynamic bodies
    using FixedBlock = ContactBlockOf<FixedSide<2>, RotatingSide, 2>;

    Float4* velocity;        ///< m/s, m/s, rad/s, 1/kg: x, y, angular, inverse mass
    Float4* deltaPosition;   ///< m, m: displacement since the start of the step; sine and (cosine - 1) of the
                             ///< rotation since then
    Float4* drive;           ///< m/s2, m/s2, rad/s2, 0: acceleration by external forces
    Float4* keep;            ///< damping factors of the velocity in a substep, w: 1; null without drag
    Float4* ballisticDrift;  ///< m, m, s: a substep moves a body by (x, y) + z * velocity (exact)
    Float4* velocityBeforeImpulses;  ///< velocity before the impulses of the current substep
};

/// State of bodies in a step without rotation, by solver slot: one row has all that contacts read.
struct BodiesWithoutRotation {
    static constexpr bool kRotate = false;
    using TwoBlock = ContactBlockOf<SideWithoutRotation, SideWithoutRotation, 1>;
    using FixedBlock = ContactBlockOf<FixedSide<1>, SideWithoutRotation, 1>;

    Float4* velocity;  ///< m/s, m/s, m, m: velocity; displacement since the start of the step
    // See SolverBodies.
    const Float4* drive;
    const Float4* keep;
    const Float4* ballisticDrift;
    Float4* velocityBeforeImpulses;
};

/// Restitution data of a block, in a parallel array that exists only if a shape in the scene bounces.
struct BounceBlock {
    float bounciness[kLanes];
    float approach[2][kLanes];  ///< m/s: relative speed along the normal before the step
    float largest[2][kLanes];   ///< N s: largest impulse of all substeps
    // Only for contacts of circles, which have a single point.
    float before[kLanes];  ///< N s: impulse of a substep before this step
    float sum[kLanes];     ///< N s: sum of all substeps; negative: it propagates no impacts
};

/// Location of a contact in the blocks.
struct ImpactPlace {
    bool fixed = false;
    std::uint8_t lane = 0;
    std::uint32_t block = 0;
};

/// Rolling resistance of a block, in a parallel array that exists only if a shape in the scene has it.
struct RollingBlock {
    float resistance[kLanes];  ///< m: maximum torque per newton of normal force
    float mass[kLanes];        ///< kg m2: effective inertia of the relative rotation
    float spin[kLanes];        ///< rad/s: angular velocity of a static or kinematic A
    float impulse[kLanes];     ///< N m s on B
};

/// Parameters of a pass over contacts.
struct ContactPass {
    Softness softness;
    float substepRate = 0.0f;   ///< 1/s
    float pushSpeed = 0.0f;     ///< m/s: see Settings::pushSpeed
    float deepPushRate = 0.0f;  ///< 1/s: see Settings::deepPushRate
    float elapsed = 0.0f;       ///< s since the start of the step
};

}  // namespace plumb::physics
