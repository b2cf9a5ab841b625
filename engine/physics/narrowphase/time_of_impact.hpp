#pragma once

#include "physics/narrowphase/distance.hpp"

namespace plumb::physics {

/// How a body moves over one step: its centre of mass straight on, while it turns evenly.
struct Sweep {
    Vec2 start;         ///< m: of the centre of mass
    Vec2 end;           ///< m
    Vec2 localCentre;   ///< m: the centre of mass in the frame of the outline
    Rot rotation;       ///< at the start
    float turn = 0.0f;  ///< rad over the whole step
};

/// @param fraction  0 at the start, 1 at the end
Frame frameAt(const Sweep& sweep, float fraction);

enum class SweepState : std::uint8_t {
    Separated,   ///< they never come nearer than the target
    Hit,         ///< they do, at the fraction
    Overlapped,  ///< they are nearer from the beginning
    Failed       ///< too many iterations: still apart at the fraction, and unknown from there on
};

struct TimeOfImpact {
    SweepState state = SweepState::Separated;
    float fraction = 1.0f;
    Vec2 normal;  ///< from A to B at the fraction; {0, 0} when separated
    int iterations = 0;
};

/// m: how much further apart than the target they may still be at a hit; a fiftieth of the default slop.
inline constexpr float kImpactTolerance = 1.0e-4f;

/// When two moving outlines first come as near as `target` to each other. Never passes the true moment.
/// @param target  m between the surfaces; negative: how deep they may be inside each other
/// Source: B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, 2.3 (conservative
///         advancement), with the bound on turning outlines taken from their reach along the normal
TimeOfImpact timeOfImpact(const Convex& a, const Sweep& sweepA, const Convex& b, const Sweep& sweepB,
                          float target);

}  // namespace plumb::physics
