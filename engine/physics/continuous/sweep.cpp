#include "physics/continuous/sweep.hpp"

#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/model/joints.hpp"
#include "physics/narrowphase/distance.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// Returns the maximum distance (m) of the outline's corners, without rounding, from the centre of rotation.
float armOf(const SweptOutline& swept) {
    const auto squareOf = [&](const Corner& corner) {
        return lengthSquared(corner.point - swept.sweep.localCentre);
    };
    return std::sqrt(largestOf(swept.outline.corners(), squareOf).value);
}

/// True if the target is one-way or a chain segment and does not stop a mover from this side.
bool opensFor(const World& world, const Mover& mover, const Mover& target) {
    const Geometry& outline = world.shapes.geometry[target.shape];
    if ((world.shapes.info[target.shape].flags & kOneWay) != 0) {
        const std::uint32_t body = world.shapes.info[mover.shape].body;
        if ((world.bodies.info[body].flags & kDropsThrough) != 0) return true;
        if (dot(openDirection(world, target.shape), mover.sweep.displacement) >= 0.0f) return true;
    }
    if (outline.kind != ShapeKind::ChainSegment) return false;
    const float begin = std::max(mover.sweep.begin, target.sweep.begin);
    const BodyPose pose = target.sweep.at(begin), from = mover.sweep.at(begin);
    const Vec2 normal = rotate(pose.rotation, normalOfChain(outline));
    const Vec2 start = rotate(pose.rotation, outline.a - pose.localCentre);
    const Convex own = convexOf(world.shapes.geometry[mover.shape], world.shapes.corners);
    const Vec2 centre = rotate(from.rotation, own.centre - from.localCentre) + (from.centre - pose.centre);
    return dot(normal, centre - start) < 0.0f;
}

bool mayCollide(const World& world, std::uint32_t a, std::uint32_t b) {
    const Shapes& shapes = world.shapes;
    if (((shapes.info[a].flags | shapes.info[b].flags) & kTrigger) != 0) return false;
    if (!mayCollide(shapes.filter[a], shapes.filter[b]) || !needsContact(world, a, b)) return false;
    const std::uint32_t bodyA = shapes.info[a].body, bodyB = shapes.info[b].body;
    return world.bodies.info[bodyA].firstJoint == kNone || !keptApart(world, bodyA, bodyB);
}

/// Fast path: true if a core stays in front of a face of a target at rest up to fraction `end` of its path,
/// like most bodies on a floor. Uses arc lengths as upper bounds of displacements by rotation.
bool staysBeyondFace(const Convex& core, const Sweep& path, const Convex& theirs, const Sweep& target,
                     float end) {
    if (target.displacement != Vec2{} || target.angle != 0.0f) return false;
    const BodyPose from = path.at(path.begin), pose = target.at(0.0f);
    const Rot relative = between(pose.rotation, from.rotation);
    const auto inTarget = [&](Vec2 point) {
        return unrotate(pose.rotation, from.centre - pose.centre) +
               rotate(relative, point - from.localCentre) + pose.localCentre;
    };
    const Vec2 centre = inTarget(core.centre);
    const Vec2 displacement = unrotate(pose.rotation, (end - path.begin) * path.displacement);
    const BestCorner beyond = largestOf(theirs.corners(), [&](const Corner& face) {
        return dot(face.normal, centre - face.point) + std::min(dot(face.normal, displacement), 0.0f);
    });
    const Vec2 normal = theirs.corners()[beyond.index].normal;
    float lever = 0.0f, extent = 0.0f;
    for (const Corner& corner : core.corners()) {
        lever = std::max(lever, lengthSquared(corner.point - from.localCentre));
        extent = std::max(extent, dot(normal, centre - inTarget(corner.point)));
    }
    const float arc = std::fabs(path.angle) * (end - path.begin) * std::sqrt(lever);
    return beyond.value > extent + arc + core.radius + theirs.radius;
}

}  // namespace

Frame relativeFrame(const BodyPose& a, const BodyPose& b) {
    const auto originOf = [](const BodyPose& pose) {
        return pose.centre + -rotate(pose.rotation, pose.localCentre);
    };
    return {unrotate(a.rotation, originOf(b) - originOf(a)), between(a.rotation, b.rotation)};
}

float firstImpact(const SweptOutline& a, const SweptOutline& b, float gap, float latest) {
    // Terms of the maximum approach along a normal in a whole step.
    const Vec2 displacement = a.sweep.displacement - b.sweep.displacement;
    const float turning = std::fabs(a.sweep.angle) * armOf(a) + std::fabs(b.sweep.angle) * armOf(b);
    SimplexCache cache;
    float part = std::max(a.sweep.begin, b.sweep.begin);
    for (int i = 0; i < kMaxRounds && part <= latest; ++i) {
        const BodyPose poseA = a.sweep.at(part), poseB = b.sweep.at(part);
        const Distance now = distanceBetween(a.outline, b.outline, relativeFrame(poseA, poseB), &cache);
        if (now.distance <= gap + 2.0f * kTouchDistance) return part;
        const float closing = dot(rotate(poseA.rotation, now.normal), displacement) + turning;
        part = closing > 0.0f ? part + (now.distance - gap) / closing : kNever;
    }
    return part <= latest ? part : kNever;
}

void meetOnPath(const World& world, const Mover& mover, const Mover& target, PathHit& next) {
    if (!mayCollide(world, mover.shape, target.shape) || opensFor(world, mover, target)) return;
    const Convex own = convexOf(world.shapes.geometry[mover.shape], world.shapes.corners);
    const Convex theirs = convexOf(world.shapes.geometry[target.shape], world.shapes.corners);
    const ScaledConvex core{own, own.centre, kSweptCore};
    if (staysBeyondFace(core.outline(), mover.sweep, theirs, target.sweep, mover.goesOn ? 2.0f : 1.0f))
        return;
    const auto impactOf = [&](const Convex& outline, float gap, float latest) {
        return firstImpact({theirs, target.sweep}, {outline, mover.sweep}, gap, latest);
    };
    const float begin = std::max(mover.sweep.begin, target.sweep.begin), latest = std::min(next.part, 1.0f);
    float part = impactOf(own, kSweptGap, latest);
    const bool isPressed = part <= begin;
    if (isPressed) {
        // The core touches at the start already (the body spins or is pressed): tries smaller cores.
        for (float size = kSweptCore; size > kLeastCore; size *= 0.5f) {
            part = impactOf(ScaledConvex{own, own.centre, size}.outline(), 0.0f, latest);
            if (part > begin) break;
        }
    }
    if (part >= next.part || part <= begin) return;
    if (!isPressed) {
        // Ignores grazing: it is a hit only if the core would touch too, in this step or, if the body
        // continues after the hit, within a path of its own length after the hit.
        const float displacement = length(mover.sweep.displacement - target.sweep.displacement);
        const float size = 2.0f * world.bodies.info[world.shapes.info[mover.shape].body].reach;
        const float further = mover.goesOn ? (displacement > size ? size / displacement : 1.0f) : 0.0f;
        if (impactOf(core.outline(), 0.0f, std::max(part + further, 1.0f)) == kNever) return;
    }
    next = {part, mover.shape, target.shape, 0, isPressed};
}

}  // namespace plumb::physics
