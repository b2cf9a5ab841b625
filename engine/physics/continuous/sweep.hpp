#pragma once

#include "physics/shapes/convex.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// The path of a body through a step, or through the rest of it: straight, at constant
/// speed. Positions on it are fractions ("parts") of the step: 0 at its start, 1 at its end.
struct Sweep {
    WorldPosition start;  ///< m, of the centre of mass at part 0
    Vec2 displacement;    ///< m in a whole step
    Rot rotation;         ///< at part 0
    float turn = 0.0f;    ///< rad in a whole step; may be several full turns
    Vec2 localCentre;     ///< m: the centre of mass in the frame of the shapes
    float begin = 0.0f;   ///< the path begins at this fraction

    [[nodiscard]] BodyPose at(float part) const;
};

/// The path that leads through a pose at a fraction of the step.
/// @param displacement, turn  in a whole step
Sweep sweepThrough(const BodyPose& pose, float part, Vec2 displacement, float turn);
inline Sweep resting(const BodyPose& pose, float part = 0.0f) { return sweepThrough(pose, part, {}, 0.0f); }

/// True if a body with this displacement (m) and rotation (rad) in a step may tunnel through
/// something thin: a point of it moves by more than half the radius of its inscribed disc.
inline bool isFast(Vec2 displacement, float rotation, const BodyInfo& info) {
    const float turned = std::fabs(rotation) * info.reach, limit = 0.5f * info.core;
    if (std::fabs(displacement.x) + std::fabs(displacement.y) + turned <= limit) return false;
    return length(displacement) + turned > limit;
}

/// The frame of B's shapes in that of A's.
Frame seenFrom(const BodyPose& a, const BodyPose& b);

/// An outline that moves along a path.
struct SweptOutline {
    const Convex& outline;
    const Sweep& sweep;
};

/// A fraction that is outside of every step.
inline constexpr float kNever = 4.0f;

/// The fraction of the step at which the distance of two outlines falls to `gap`, not before both paths
/// begin; kNever if not until `latest`. Never too late: with too many iterations it returns early.
/// @param gap     m, not negative
/// @param latest  below kNever
/// Source: B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, 2.3 (conservative
///         advancement)
float firstImpact(const SweptOutline& a, const SweptOutline& b, float gap, float latest = 1.0f);

struct PathHit {
    float part = kNever;
    std::uint32_t shape = kNone;  ///< of the body
    std::uint32_t met = kNone;    ///< the other shape
    int metHits = 0;              ///< hits of the other body: if it has more by now, its path has changed
    bool isPressed = false;       ///< they touched at the start, and now a core would pass through
};

/// A body that moved fast, or was hit by one that did.
struct SweptBody {
    std::uint32_t body = kNone;
    Sweep sweep;                   ///< since its last hit
    Vec2 pull;                     ///< m/s2: acceleration along this path
    bool isHeld = false;           ///< by contacts or joints: a hit stops it; the solver handles the rest
    int hits = 0;                  ///< number of hits that changed its path
    std::uint32_t passed = kNone;  ///< shape that the owner's callback lets it pass
    PathHit next;
};

struct Mover {
    std::uint32_t shape;
    const Sweep& sweep;
    bool goesOn = false;  ///< it continues after a hit
};

/// Finds the time at which the mover hits the target, and stores it if it is before `next`.
void meetOnPath(const World& world, const Mover& mover, const Mover& target, PathHit& next);

}  // namespace plumb::physics
