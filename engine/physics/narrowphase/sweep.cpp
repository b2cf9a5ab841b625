#include "physics/narrowphase/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "physics/narrowphase/distance.hpp"

namespace plumb::physics {

namespace {

constexpr int kMostAdvances = 64;
/// m: nearer to the gap than this is at it.
constexpr float kTolerance = 1.0e-4f;

/// m: how far the outline's corners are from the centre that they turn about. Its radius turns in place.
float armOf(const SweptOutline& swept) {
    float square = 0.0f;
    for (const Corner& corner : swept.outline.corners()) {
        square = std::max(square, lengthSquared(corner.point - swept.sweep.localCentre));
    }
    return std::sqrt(square);
}

Place originOf(const BodyPose& pose) { return pose.centre + -rotate(pose.rotation, pose.localCentre); }

Frame seenFrom(const BodyPose& a, const BodyPose& b) {
    return {unrotate(a.rotation, originOf(b) - originOf(a)), between(a.rotation, b.rotation)};
}

/// What is left of the movement at a part of the way.
Vec2 wayFrom(const Sweep& sweep, float part) { return part < sweep.end ? sweep.way : Vec2{}; }
float turnFrom(const Sweep& sweep, float part) { return part < sweep.end ? std::fabs(sweep.turn) : 0.0f; }

}  // namespace

BodyPose Sweep::at(float part) const {
    const float reached = std::min(part, end);
    return {start + way * reached, normalized(rotFromAngle(turn * reached) * rotation), localCentre};
}

Sweep resting(const BodyPose& pose) { return {pose.centre, {}, pose.rotation, 0.0f, pose.localCentre, 0.0f}; }

std::optional<Impact> firstImpact(const SweptOutline& a, const SweptOutline& b, float gap, float latest) {
    const float armA = armOf(a), armB = armOf(b);
    SimplexCache cache;
    Impact impact;
    for (int i = 0; i < kMostAdvances; ++i) {
        const BodyPose poseA = a.sweep.at(impact.part), poseB = b.sweep.at(impact.part);
        const Distance now = distanceBetween(a.outline, b.outline, seenFrom(poseA, poseB), &cache);
        impact.normal = rotate(poseA.rotation, now.normal);
        impact.point = originOf(poseA) + rotate(poseA.rotation, now.pointA);
        if (now.distance <= gap + kTolerance) return impact;
        // No point comes nearer along the normal than this for the whole way.
        const float closing =
            dot(impact.normal, wayFrom(a.sweep, impact.part) - wayFrom(b.sweep, impact.part)) +
            turnFrom(a.sweep, impact.part) * armA + turnFrom(b.sweep, impact.part) * armB;
        float next = closing > 0.0f ? impact.part + (now.distance - gap) / closing : 2.0f;
        for (const float end : {a.sweep.end, b.sweep.end}) {
            if (impact.part < end) next = std::min(next, end);
        }
        if (next > latest || impact.part >= std::max(a.sweep.end, b.sweep.end)) return std::nullopt;
        impact.part = next;
    }
    return impact;
}

}  // namespace plumb::physics
