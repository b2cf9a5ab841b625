#pragma once

#include "physics/shapes/convex.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// The path of a body through a step, or through what is left of it: straight and even. Parts of it are 0 at
/// the start of the step and 1 at its end.
struct Sweep {
    WorldPosition start;  ///< m, of the centre of mass at part 0
    Vec2 displacement;    ///< m in a whole step
    Rot rotation;         ///< at part 0
    float turn = 0.0f;    ///< rad in a whole step; may be several full turns
    Vec2 localCentre;     ///< m: the centre of mass in the frame of the shapes
    float begin = 0.0f;   ///< from this part on

    [[nodiscard]] BodyPose at(float part) const;
};

/// The path that leads through a pose at a part of the step.
/// @param way, turn  in a whole step
Sweep sweepThrough(const BodyPose& pose, float part, Vec2 displacement, float turn);
inline Sweep resting(const BodyPose& pose, float part = 0.0f) { return sweepThrough(pose, part, {}, 0.0f); }

/// Whether a displacement (m) and a rotation (rad) in one step may carry a body past something thin: some
/// point of it moves by more than half the radius of its inscribed disc.
inline bool isFast(Vec2 displacement, float rotation, const BodyInfo& info) {
    const float turned = std::fabs(rotation) * info.reach, limit = 0.5f * info.core;
    if (std::fabs(displacement.x) + std::fabs(displacement.y) + turned <= limit) return false;
    return length(displacement) + turned > limit;
}

/// The frame of B's shapes in that of A's.
Frame seenFrom(const BodyPose& a, const BodyPose& b);

/// An outline that is taken along.
struct SweptOutline {
    const Convex& outline;
    const Sweep& sweep;
};

/// A part that no step has.
inline constexpr float kNever = 4.0f;

/// The part of the step at which two outlines come as near as `gap`; where both paths have begun, when they
/// are then already; kNever if not until `latest`. Never too late: what takes too many rounds is found early.
/// @param gap     m, not negative
/// @param latest  below kNever
/// Source: B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, 2.3 (conservative
///         advancement)
float firstImpact(const SweptOutline& a, const SweptOutline& b, float gap, float latest = 1.0f);

struct PathHit {
    float part = kNever;
    std::uint32_t shape = kNone;  ///< of the body
    std::uint32_t met = kNone;    ///< the other shape
    int metHits = 0;              ///< of the other body: when it has more, its path is another one
    bool isPressed = false;       ///< they touched from the start, and now a core would pass
};

/// A body that moved fast, or was hit by one that did.
struct SweptBody {
    std::uint32_t body = kNone;
    Sweep sweep;                   ///< since its last hit
    Vec2 pull;                     ///< m/s2: by how much it gets faster on this path
    bool isHeld = false;           ///< by contacts or joints: a hit stops it, and the solver does the rest
    int hits = 0;                  ///< that changed its path
    std::uint32_t passed = kNone;  ///< shape that the owner of the world let it pass
    PathHit next;
};

struct Mover {
    std::uint32_t shape;
    const Sweep& sweep;
    bool goesOn = false;  ///< after a hit
};

/// Notes what the mover hits, if that is before `next`.
void meetOnPath(const World& world, const Mover& mover, const Mover& target, PathHit& next);

}  // namespace plumb::physics
