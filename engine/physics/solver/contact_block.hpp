#pragma once

#include <cstddef>
#include <cstdint>

#include "physics/lanes.hpp"
#include "physics/softness.hpp"

namespace plumb::physics {

/// The rows of four floats that make up a Contact, for code that reads eight contacts at once.
enum ContactRow {
    kSurfaceRow = 1,
    kNormalRow = 2,
    kImpulseRow = 3,
    kTurnRow = 4,
    kAnchorsRow = 5,
    kRoundRow = 7,
    kContactRows = 8
};

/// A body of eight contacts that can rotate. A lever is the cross product of the arm and a direction.
struct RotatingSide {
    static constexpr bool kFixed = false;
    std::int32_t slot[kLanes];
    float inverseInertia[kLanes];
    float lever[2][kLanes];  ///< m: by point, along the normal
    float turn[kLanes];      ///< m: dot(arm, normal) of the part of the arm that rotates with the body
    float slide[kLanes];     ///< m: dot(arm, normal), the lever of friction
};

/// A body in a step without rotation: no lever matters.
struct SideWithoutRotation {
    static constexpr bool kFixed = false;
    std::uint32_t offset[kLanes];  ///< bytes: of its state
    float inverseMass[kLanes];
};

/// A static or kinematic body.
template <std::size_t kPoints>
struct FixedSide {
    static constexpr bool kFixed = true;
    float approach[kPoints][kLanes];  ///< m/s along the normal: velocity of its surface at each point
};

/// A point of eight contacts.
struct ContactBlockPoint {
    float separation[kLanes];  ///< m, at the start of the step
    float gap[kLanes];         ///< m, now
    float mass[kLanes];        ///< kg: effective mass along the normal
    float impulse[kLanes];     ///< N s
};

/// Eight contacts of one color, one per SIMD lane: no body that moves appears twice. Friction of two points
/// acts along one line, so it is a single constraint at their midpoint. Source: E. Catto, "Iterative Dynamics
/// with Temporal Coherence", GDC 2005.
template <class SideA, class SideB, std::size_t kPointCount>
struct ContactBlockOf {
    static constexpr int kPoints = int{kPointCount};

    SideA a;
    SideB b;
    VecLanes normal;
    ContactBlockPoint points[kPointCount];
    float friction[kLanes];    ///< this and the following only with friction
    float slideSpeed[kLanes];  ///< m/s: of the surfaces themselves (conveyors, kinematic bodies)
    float slideMass[kLanes];
    float slideImpulse[kLanes];
};

/// State of the bodies of a step, by solver slot, in flat arrays so that a pass reads nothing else. Eight
/// idle slots at the end serve SIMD lanes without a body.
struct SolverBodies {
    static constexpr bool kRotate = true;
    using TwoBlock = ContactBlockOf<RotatingSide, RotatingSide, 2>;  ///< of contacts between two of them
    using FixedBlock = ContactBlockOf<FixedSide<2>, RotatingSide, 2>;

    Float4* velocity;       ///< m/s, m/s, rad/s, 1/kg: x, y, angular, inverse mass
    Float4* deltaPosition;  ///< m, m: displacement since the start of the step; sine and (cosine - 1) of the
                            ///< rotation since then
    Float4* drive;          ///< m/s2, m/s2, rad/s2, 0: acceleration by external forces
    Float4* keep;           ///< damping: factor on the velocity in each substep, w: 1; null without drag
    Float4*
        ballisticDrift;  ///< m, m, s: a substep moves a body by x, y + z * velocity: exact ballistic motion
    Float4* velocityBeforeImpulses;  ///< the velocity without the impulses of this substep
};

/// State of bodies in a step without rotation, by solver slot: all that a contact needs in one row.
struct BodiesWithoutRotation {
    static constexpr bool kRotate = false;
    using TwoBlock = ContactBlockOf<SideWithoutRotation, SideWithoutRotation, 1>;
    using FixedBlock = ContactBlockOf<FixedSide<1>, SideWithoutRotation, 1>;

    Float4* velocity;  ///< m/s, m/s, m, m: velocity; displacement since the start of the step
    // As in SolverBodies.
    const Float4* drive;
    const Float4* keep;
    const Float4* ballisticDrift;
    Float4* velocityBeforeImpulses;
};

/// Restitution data of a block, in a parallel array that exists only if something in the scene bounces.
struct BounceBlock {
    float bounciness[kLanes];
    float approach[2][kLanes];  ///< m/s: relative speed along the normal before the step
    float largest[2][kLanes];   ///< N s: the largest impulse of any substep
    // Only of round contacts, which have a single point.
    float before[kLanes];  ///< N s: of one substep, before the step
    float sum[kLanes];     ///< N s: of all substeps; negative if the contact does not propagate impacts
};

/// Index of a contact in the blocks.
struct ImpactPlace {
    bool fixed = false;
    std::uint8_t lane = 0;
    std::uint32_t block = 0;
};

/// Rolling resistance of a block, in a parallel array that exists only if something in the scene has it.
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
    float pushSpeed = 0.0f;     ///< m/s: maximum speed at which overlaps are pushed out,
    float deepPushRate = 0.0f;  ///< 1/s: and its increase per meter of depth
    float elapsed = 0.0f;       ///< s since the start of the step
};

}  // namespace plumb::physics
