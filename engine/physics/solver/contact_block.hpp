#pragma once

#include <cstdint>

#include "physics/solver/lanes.hpp"

namespace plumb::physics {

/// State of the bodies of a step, by solver slot, in flat arrays so that a pass reads nothing else. Eight
/// idle slots at the end serve SIMD lanes without a body.
struct SolverBodies {
    Float4* velocity;       ///< m/s, m/s, rad/s, 1/kg: x, y, angular, inverse mass
    Float4* deltaPosition;  ///< m, m: displacement since the start of the step; sine and (cosine - 1) of the
                            ///< rotation since then
    Float4* drive;          ///< m/s2, m/s2, rad/s2, 0: acceleration by external forces
    Float4* keep;           ///< damping: factor on the velocity in each substep, w: 1; null without drag
    Float4*
        ballisticDrift;  ///< m, m, s: a substep moves a body by x, y + z * velocity: exact ballistic motion
    Float4* velocityBeforeImpulses;  ///< the velocity without the impulses of this substep
};

/// One of the two points of eight contacts.
struct ContactBlockPoint {
    float leverA[kLanes];  ///< m: cross(arm, normal)
    float leverB[kLanes];
    float separation[kLanes];  ///< m, at the start of the step
    float gap[kLanes];         ///< m, now
    float mass[kLanes];        ///< kg: effective mass along the normal
    float impulse[kLanes];     ///< N s
};

/// Eight contacts of one color between dynamic bodies, one per SIMD lane: no body appears twice. Friction of
/// both points acts along one line, so it is a single constraint at their midpoint. Source: E. Catto,
/// "Iterative Dynamics with Temporal Coherence", GDC 2005.
struct ContactBlock {
    std::int32_t a[kLanes];  ///< slots
    std::int32_t b[kLanes];
    float normalX[kLanes];
    float normalY[kLanes];
    float inverseInertiaA[kLanes];
    float inverseInertiaB[kLanes];
    float turnA[kLanes];  ///< m: dot(arm, normal) of the part of the arm that rotates with the body
    float turnB[kLanes];
    float slideA[kLanes];  ///< m: dot(arm, normal), the lever arm of friction
    float slideB[kLanes];
    float slideSpeed[kLanes];  ///< m/s: of the surfaces themselves (conveyors)
    float slideMass[kLanes];
    float slideImpulse[kLanes];
    float friction[kLanes];
    ContactBlockPoint points[2];
};

struct FixedContactBlockPoint {
    float lever[kLanes];
    float separation[kLanes];
    float gap[kLanes];
    float approach[kLanes];  ///< m/s along the normal: velocity of A's surface at this point
    float mass[kLanes];
    float impulse[kLanes];
};

/// Eight contacts of one color, each of a dynamic body B with a static or kinematic body A.
struct FixedContactBlock {
    std::int32_t b[kLanes];
    float normalX[kLanes];
    float normalY[kLanes];
    float inverseInertia[kLanes];
    float turn[kLanes];
    float slide[kLanes];
    float slideSpeed[kLanes];
    float slideMass[kLanes];
    float slideImpulse[kLanes];
    float friction[kLanes];
    FixedContactBlockPoint points[2];
};

/// State of bodies in a step without rotation, by solver slot: all that a contact needs in one row.
struct BodiesWithoutRotation {
    Float4* state;  ///< m/s, m/s, m, m: velocity; displacement since the start of the step
    // As in SolverBodies.
    const Float4* drive;
    const Float4* keep;
    const Float4* ballisticDrift;
    Float4* velocityBeforeImpulses;
};

/// Eight contacts of one color in a step without rotation: one point each, without a lever arm.
struct BlockWithoutRotation {
    std::uint32_t a[kLanes];  ///< byte offset of a body's state
    std::uint32_t b[kLanes];
    float inverseMassA[kLanes];
    float inverseMassB[kLanes];
    float normalX[kLanes];
    float normalY[kLanes];
    float separation[kLanes];
    float gap[kLanes];
    float mass[kLanes];  ///< kg: effective mass along any direction
    float impulse[kLanes];
    float friction[kLanes];  ///< this and the following only with friction
    float slideSpeed[kLanes];
    float slideImpulse[kLanes];
};

/// The same for a dynamic body B and a static or kinematic body A.
struct FixedBlockWithoutRotation {
    std::uint32_t b[kLanes];
    float inverseMass[kLanes];
    float normalX[kLanes];
    float normalY[kLanes];
    float separation[kLanes];
    float gap[kLanes];
    float approach[kLanes];
    float mass[kLanes];
    float impulse[kLanes];
    float friction[kLanes];
    float slideSpeed[kLanes];
    float slideImpulse[kLanes];
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

/// Contacts of a block: indices into World::contacts. Entries from `count` on are unused.
struct BlockLanes {
    std::int32_t contact[kLanes];
    std::int32_t count;
};

/// Soft constraint parameters: a spring as a velocity constraint. Source: E. Catto, "Soft Constraints", GDC
/// 2011.
struct Softness {
    float biasRate = 0.0f;  ///< 1/s
    float massScale = 1.0f;
    float impulseScale = 0.0f;
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
