#pragma once

#include "physics/shapes/convex.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// The path of a body during a step or the rest of a step: straight, at constant speed. Times are fractions
/// of the step ("parts"): 0 at its start, 1 at its end.
struct Sweep {
    WorldPosition start;  ///< m: position of the centre of mass at part 0
    Vec2 displacement;    ///< m in a whole step
    Rot rotation;         ///< at part 0
    float angle = 0.0f;   ///< rad: rotation in a whole step; may exceed 2 pi
    Vec2 localCentre;     ///< m: the centre of mass in the frame of the shapes
    float begin = 0.0f;   ///< fraction of the step at which the path begins

    [[nodiscard]] BodyPose at(float part) const {
        const Rot turned = angle == 0.0f ? rotation : rotFromAngle(angle * part) * rotation;
        return {start + displacement * part, normalized(turned), localCentre};
    }
};

/// Returns the path on which the body has the given pose at a fraction of the step.
/// @param displacement, angle  m and rad in a whole step
inline Sweep sweepThrough(const BodyPose& pose, float part, Vec2 displacement, float angle) {
    const Rot back = angle == 0.0f ? pose.rotation : normalized(rotFromAngle(-angle * part) * pose.rotation);
    return {pose.centre + displacement * -part, displacement, back, angle, pose.localCentre, part};
}
inline Sweep resting(const BodyPose& pose, float part = 0.0f) { return sweepThrough(pose, part, {}, 0.0f); }

/// True if a body with this displacement (m) and rotation (rad) in a step may tunnel through a thin shape: a
/// point of the body moves by more than half the radius of its inscribed disc.
inline bool isFast(Vec2 displacement, float rotation, const BodyInfo& info) {
    const float turned = std::fabs(rotation) * info.reach, limit = 0.5f * info.core;
    if (std::fabs(displacement.x) + std::fabs(displacement.y) + turned <= limit) return false;
    return length(displacement) + turned > limit;
}

/// Returns the frame of B's shapes relative to the frame of A's shapes.
Frame relativeFrame(const BodyPose& a, const BodyPose& b);

/// An outline that moves along a path.
struct SweptOutline {
    const Convex& outline;
    const Sweep& sweep;
};

/// A fraction of the step that stands for "no hit".
inline constexpr float kNever = 4.0f;

/// Returns the fraction of the step at which the distance of two outlines falls to `gap`, after the begin of
/// both paths; kNever if it does not until `latest`. At the limit of iterations, returns an earlier fraction.
/// @param gap     m, not negative
/// @param latest  below kNever
/// Source: B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, 2.3 (conservative
///         advancement)
float firstImpact(const SweptOutline& a, const SweptOutline& b, float gap, float latest = 1.0f);

struct PathHit {
    float part = kNever;          ///< fraction of the step at which the shapes hit
    std::uint32_t shape = kNone;  ///< the shape of the swept body
    std::uint32_t other = kNone;  ///< the shape of another body that it hits
    int otherHits = 0;       ///< SweptBody::hits of the other body; a higher number now: it changed its path
    bool isPressed = false;  ///< the shapes touched at the start; now the core of one would enter the other
};

/// A fast body, or a body that a fast body hit.
struct SweptBody {
    std::uint32_t body = kNone;
    Sweep sweep;          ///< its path since its last hit
    Vec2 pull;            ///< m/s2: acceleration on this path
    bool isHeld = false;  ///< true if it has contacts or joints: a hit then stops it until the next step
    int hits = 0;         ///< number of hits that changed its path
    std::uint32_t passed = kNone;  ///< shape that it passes through, by a callback of ContactHooks
    PathHit next;                  ///< the next hit on the path
};

struct Mover {  // a shape on the path of its body
    std::uint32_t shape;
    const Sweep& sweep;
    bool goesOn = false;  ///< true if it continues to move after a hit
};

/// Finds the time at which the mover hits the target, and stores it if it is earlier than `next`.
void meetOnPath(const World& world, const Mover& mover, const Mover& target, PathHit& next);

}  // namespace plumb::physics
