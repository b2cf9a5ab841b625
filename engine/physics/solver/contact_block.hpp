#pragma once

#include <cstdint>

#include "physics/solver/lanes.hpp"

namespace plumb::physics {

/// What the solver knows of the bodies of a step, by slot. Flat, so that a pass touches nothing else.
/// The arrays end with eight idle slots, for lanes that have no body.
struct SolverBodies {
    Float4* velocity;  ///< m/s, m/s, rad/s, 1/kg: x, y, angular, inverse mass
    Float4* shift;  ///< m, m: moved since the start of the step; sine and (cosine - 1) of the turn since then
    Float4* drive;  ///< m/s2, m/s2, rad/s2, 0: what forces do
    Float4* keep;   ///< the part of its velocity that drag leaves a body in a substep, w: 1; null for no drag
    Float4* flight;       ///< m, m, s: what a substep adds to `shift` besides z * velocity: exact free flight
    Float4* undisturbed;  ///< the velocity without the impulses of this substep
};

/// One of the two points of eight contacts.
struct ContactBlockPoint {
    float leverA[kLanes];  ///< m: cross(arm, normal)
    float leverB[kLanes];
    float separation[kLanes];  ///< m, at the start of the step
    float gap[kLanes];         ///< m, now
    float mass[kLanes];        ///< kg that the point offers to a push along the normal
    float impulse[kLanes];     ///< N s
};

/// Eight contacts of one colour, between bodies that all can be pushed: no body appears twice.
/// Source: E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005. Friction of both points acts
/// along one line, so it is one constraint, at their middle.
struct ContactBlock {
    std::int32_t a[kLanes];  ///< slots
    std::int32_t b[kLanes];
    float normalX[kLanes];
    float normalY[kLanes];
    float inverseInertiaA[kLanes];
    float inverseInertiaB[kLanes];
    float turnA[kLanes];  ///< m: dot(arm, normal) of the part of the arm that turns with the body
    float turnB[kLanes];
    float slideA[kLanes];  ///< m: dot(arm, normal), the lever of friction
    float slideB[kLanes];
    float slideSpeed[kLanes];  ///< m/s: of the surfaces themselves, as conveyors
    float slideMass[kLanes];
    float slideImpulse[kLanes];
    float friction[kLanes];
    ContactBlockPoint points[2];
};

struct FixedContactBlockPoint {
    float lever[kLanes];
    float separation[kLanes];
    float gap[kLanes];
    float approach[kLanes];  ///< m/s along the normal: of the fixed body's surface here
    float mass[kLanes];
    float impulse[kLanes];
};

/// Eight contacts of one colour, each of a body B that can be pushed with a body A that cannot.
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

/// What the solver knows of bodies that nothing turns, by slot: all that a contact needs in one row.
struct PlainBodies {
    Float4* state;  ///< m/s, m/s, m, m: velocity x, y; moved since the start of the step
    // The same as of SolverBodies.
    const Float4* drive;
    const Float4* keep;
    const Float4* flight;
    Float4* undisturbed;
};

/// Eight contacts of one colour where nobody turns: one point each, without a lever.
struct PlainBlock {
    std::uint32_t a[kLanes];  ///< bytes from the first state to that of a body
    std::uint32_t b[kLanes];
    float inverseMassA[kLanes];
    float inverseMassB[kLanes];
    float normalX[kLanes];
    float normalY[kLanes];
    float separation[kLanes];
    float gap[kLanes];
    float mass[kLanes];  ///< kg that both offer to a push along any direction
    float impulse[kLanes];
    float friction[kLanes];  ///< the rest only where something rubs
    float slideSpeed[kLanes];
    float slideImpulse[kLanes];
};

/// The same of a body B that can be pushed with a body A that cannot.
struct PlainFixedBlock {
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

/// What bounces of a block, beside it, only where something in the scene bounces.
struct BounceBlock {
    float bounciness[kLanes];
    float approach[2][kLanes];  ///< m/s: relative speed along the normal before the step
    float largest[2][kLanes];   ///< N s: the largest impulse of any substep
    // Of round contacts, which have one point.
    float before[kLanes];  ///< N s: of a substep, before the step
    float sum[kLanes];     ///< N s: of all substeps; below 0 where no impact runs on through this contact
};

/// A contact among the blocks.
struct ImpactPlace {
    bool fixed = false;
    std::uint8_t lane = 0;
    std::uint32_t block = 0;
};

/// A body of some impact, as the substeps left it.
struct HitBody {
    std::size_t slot = 0;
    Float4 velocity;
    Float4 shift;
};

/// What the substeps left of an impact.
struct HitImpulse {
    float impulse = 0.0f;   ///< N s
    float approach = 0.0f;  ///< m/s, at the start of the step
};

/// What resists rolling in a block, beside it, only where something in the scene does.
struct RollingBlock {
    float resistance[kLanes];  ///< m: torque for each newton that presses them together
    float mass[kLanes];        ///< kg m2 that both offer to a torque between them
    float spin[kLanes];        ///< rad/s of A, where it is a body that cannot be pushed
    float impulse[kLanes];     ///< N m s on B
};

/// Which contacts are in a block: indices into World::contacts; -1 for an empty lane.
struct BlockLanes {
    std::int32_t contact[kLanes];
    std::int32_t count;
};

/// A spring, made to act on velocities: source E. Catto, "Soft Constraints", GDC 2011.
struct Softness {
    float biasRate = 0.0f;  ///< 1/s
    float massScale = 1.0f;
    float impulseScale = 0.0f;
};

/// What a pass over contacts needs to know.
struct ContactPass {
    Softness softness;
    float substepRate = 0.0f;   ///< 1/s
    float pushSpeed = 0.0f;     ///< m/s: overlaps are taken out no faster,
    float deepPushRate = 0.0f;  ///< 1/s: but by this times their depth
    float elapsed = 0.0f;       ///< s since the start of the step
};

}  // namespace plumb::physics
