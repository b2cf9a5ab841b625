#include "physics/narrowphase/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "physics/narrowphase/distance.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// m: how far the outline's corners are from the centre that they turn about. Its radius turns in place.
float armOf(const SweptOutline& swept) {
    float square = 0.0f;
    for (const Corner& corner : swept.outline.corners()) {
        square = std::max(square, lengthSquared(corner.point - swept.sweep.localCentre));
    }
    return std::sqrt(square);
}

}  // namespace

BodyPose Sweep::at(float part) const {
    const Rot turned = turn == 0.0f ? rotation : rotFromAngle(turn * part) * rotation;
    return {start + displacement * part, normalized(turned), localCentre};
}

Sweep sweepThrough(const BodyPose& pose, float part, Vec2 displacement, float turn) {
    const Rot before = turn == 0.0f ? pose.rotation : normalized(rotFromAngle(-turn * part) * pose.rotation);
    return {pose.centre + displacement * -part, displacement, before, turn, pose.localCentre, part};
}

Frame seenFrom(const BodyPose& a, const BodyPose& b) {
    const auto originOf = [](const BodyPose& pose) {
        return pose.centre + -rotate(pose.rotation, pose.localCentre);
    };
    return {unrotate(a.rotation, originOf(b) - originOf(a)), between(a.rotation, b.rotation)};
}

float firstImpact(const SweptOutline& a, const SweptOutline& b, float gap, float latest) {
    // No point comes nearer along a normal than by this in a whole step.
    const Vec2 displacement = a.sweep.displacement - b.sweep.displacement;
    const float turning = std::fabs(a.sweep.turn) * armOf(a) + std::fabs(b.sweep.turn) * armOf(b);
    SimplexCache cache;
    float part = std::max(a.sweep.begin, b.sweep.begin);
    for (int i = 0; i < kMaxRounds && part <= latest; ++i) {
        const BodyPose poseA = a.sweep.at(part), poseB = b.sweep.at(part);
        const Distance now = distanceBetween(a.outline, b.outline, seenFrom(poseA, poseB), &cache);
        if (now.distance <= gap + 2.0f * kTouchDistance) return part;
        const float closing = dot(rotate(poseA.rotation, now.normal), displacement) + turning;
        part = closing > 0.0f ? part + (now.distance - gap) / closing : kNever;
    }
    return part <= latest ? part : kNever;
}

}  // namespace plumb::physics
