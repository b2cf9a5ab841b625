#include <algorithm>

#include "physics/bounds.hpp"
#include "physics/broadphase/overlap.hpp"
#include "physics/continuous/swept_bodies.hpp"
#include "physics/edits.hpp"
#include "physics/model/joints.hpp"
#include "physics/ranges.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/solver/contact_extras.hpp"

namespace plumb::physics {

namespace {

constexpr int kFinishGrain = 256;

/// True if x, y, z are finite: 0 * NaN and 0 * infinity are NaN, so only then the sum is 0.
bool isFinite(const Float4& a) { return 0.0f * a.x + 0.0f * a.y + 0.0f * a.z == 0.0f; }

bool isSound(const Workspace& work, std::size_t slot) {
    return isFinite(work.velocity[slot]) && isFinite(work.deltaPosition[slot]);
}

/// Converts -0.0 to +0.0, so that hashes do not depend on how a zero was computed.
Vec2 unsigned0(Vec2 a) { return a + Vec2{}; }

Vec2 shortened(Vec2 a, float maximum) {
    const float square = lengthSquared(a);
    return square > maximum * maximum ? (maximum / std::sqrt(square)) * a : a;
}

FieldMotion fieldMotionOf(const StepContext& step, std::size_t slot) {
    const std::vector<FieldMotion>& motions = step.work.smooth.motions;
    return motions.empty() ? FieldMotion::Steady : motions[slot];
}

/// True for a body in free flight: accelerated and without contacts.
bool isBallistic(const Workspace& work, std::size_t slot) {
    return work.ballisticDrift[slot].x != 0.0f || work.ballisticDrift[slot].y != 0.0f;
}

/// True if a motor moves the body, at half of its target speed or more. One that is stopped may rest.
bool isMotored(const StepContext& step, std::uint32_t body) {
    const World& world = step.world;
    bool motored = false;
    if (!step.runs(Effect::Motors)) return false;
    forJointsOf(world, body, [&](std::uint32_t j) {
        const bool driven = (world.joints.hot[j].flags & kDriven) != 0;
        const float target = driven ? world.joints.definition[j].motor.speed : 0.0f;
        motored = motored || (target != 0.0f && readingOf(world, idOfJoint(world, j)).speed / target > 0.5f);
    });
    return motored;
}

/// Returns the speed (m/s) below which a body is at rest. A body that only fields push, such as a bubble, may
/// move at any speed for ever, so it must move by less than the slop per sleepTime. 0 for falling bodies and
/// those that a motor moves.
float restSpeed(const StepContext& step, std::size_t slot, std::uint32_t body) {
    const BodyInfo& info = step.world.bodies.info[body];
    const Settings& settings = step.world.settings;
    if (isMotored(step, body)) return 0.0f;
    if (fieldMotionOf(step, slot) == FieldMotion::Free)
        return std::min(info.sleepSpeed, settings.slop / std::max(settings.sleepTime, step.dt));
    return info.firstJoint == kNone && isBallistic(step.work, slot) ? 0.0f : info.sleepSpeed;
}

/// Returns the time (s) for which the body has been at rest, i.e. slower than `restSpeed`. Faster motion
/// reduces it by the ratio of the energies, so that a swaying pile also comes to rest, such as a tall pyramid
/// in which single boxes are too fast from time to time.
float restTimeAfter(const BodyMotion& motion, float reach, float restSpeed, float dt) {
    const float spin = motion.angularVelocity * reach;  // m/s: upper bound of the speed of its points
    const float square = std::max(lengthSquared(motion.velocity), spin * spin);
    const float maximum = restSpeed * restSpeed;
    if (square <= maximum) return motion.restTime + dt;
    return maximum > 0.0f ? std::max(0.0f, motion.restTime - dt * (square / maximum - 1.0f)) : 0.0f;
}

/// True if the filters of the body's shapes allow any collisions.
bool meetsSome(const World& world, std::uint32_t body) {
    FilterUnion filters;
    forShapesOf(world, body, [&](std::uint32_t s) { filters.add(world.shapes.filter[s]); });
    return filters.layers != 0 && filters.masks != 0;
}

/// Like boundsOf(), with a fast path for axis-aligned boxes.
AABB tightBounds(const Shapes& shapes, std::uint32_t shape, const Frame& frame) {
    const Geometry& outline = shapes.geometry[shape];
    const bool upright =
        outline.kind == ShapeKind::Box && frame.rotation == Rot{} && outline.rotation == Rot{};
    if (!upright || outline.radius != 0.0f) return boundsOf(outline, shapes.corners, frame);
    const Vec2 centre = frame.position + outline.a;
    return {centre - outline.b, centre + outline.b};
}

void updateShapes(World& world, std::uint32_t body, std::vector<std::uint32_t>& left) {
    const Frame frame = frameOf(world.bodies.pose[body]);
    Shapes& shapes = world.shapes;
    forShapesOf(world, body, [&](std::uint32_t s) {
        const AABB tight = tightBounds(shapes, s, frame);
        if (contains(shapes.bounds[s], tight)) return;
        shapes.bounds[s] = grown(tight, shapes.info[s].margin);
        left.push_back(s);
    });
}

/// Returns the error (m) of the displacement of a sliding or rolling body under a constant force. A substep
/// moves by its final velocity, which is too large by h/2 times the acceleration; over a step the sum is h/2
/// times the change of velocity. 0 for free bodies, which move exactly, and for impacts.
Vec2 overshoot(const StepContext& step, std::size_t slot, std::uint32_t body, Vec2 before, Vec2 velocity) {
    const Vec2 gained = velocity - before;
    const Float4& pull = step.work.drive[slot];
    const float slowest = kLivelyPart * step.world.settings.bounceSpeed;
    const float rounding = lengthSquared(velocity) > slowest * slowest ? kRounded : 1.0f;
    const float maximum = rounding * (pull.x * pull.x + pull.y * pull.y) * step.dt * step.dt;
    if (isBallistic(step.work, slot) || lengthSquared(gained) > maximum) return {};
    if (fieldMotionOf(step, slot) == FieldMotion::Driven) return {};  // its force is not constant
    if (step.world.bodies.info[body].firstJoint != kNone) return {};  // the rotation would need one as well
    return (0.5f * step.work.ballisticDrift[slot].z) * gained;
}

bool isReachable(WorldPosition a) { return std::fabs(a.x) <= kFarthest && std::fabs(a.y) <= kFarthest; }

/// Moves a body to its new pose.
/// @return false if its state is not finite or the pose is beyond kFarthest; then it stops at its old pose
bool takeAlong(StepContext& step, std::size_t slot, std::uint32_t body) {
    Bodies& bodies = step.world.bodies;
    BodyMotion& motion = bodies.motion[body];
    const Float4& velocity = step.work.velocity[slot];
    Float4& deltaPosition = step.work.deltaPosition[slot];
    const Vec2 free{deltaPosition.x, deltaPosition.y};
    if (!isSound(step.work, slot) || !isReachable(bodies.pose[body].centre + free)) {
        motion.velocity = {};
        motion.angularVelocity = 0.0f;
        return false;
    }
    // Substeps may exceed the maximum speed even if the final velocity does not.
    Vec2 displacement = shortened(free, step.world.settings.maxSpeed * step.dt);
    deltaPosition.x = displacement.x, deltaPosition.y = displacement.y;
    const Vec2 before = motion.velocity;
    motion.velocity = unsigned0({velocity.x, velocity.y});
    motion.angularVelocity = velocity.z + 0.0f;
    limitMotion(step.world, body);
    displacement -= overshoot(step, slot, body, before, motion.velocity);
    BodyPose& pose = bodies.pose[body];
    pose.centre = pose.centre + unsigned0(displacement);
    if (deltaPosition.z != 0.0f || deltaPosition.w != 0.0f)
        pose.rotation = normalized(Rot{1.0f + deltaPosition.w, deltaPosition.z} * pose.rotation);
    return true;
}

void finish(StepContext& step, std::size_t slot, std::uint32_t body, BodyFindings& found) {
    World& world = step.world;
    BodyInfo& info = world.bodies.info[body];
    if (!takeAlong(step, slot, body)) return found.broken.push_back(body);
    const Float4& deltaPosition = step.work.deltaPosition[slot];
    const bool moved = deltaPosition.x != 0.0f || deltaPosition.y != 0.0f || deltaPosition.z != 0.0f;
    info.flags = static_cast<std::uint8_t>(moved ? info.flags | kMoved : info.flags & ~kMoved);
    BodyMotion& motion = world.bodies.motion[body];
    if (info.kind == BodyKind::Kinematic) {
        if ((info.flags & kHasTarget) != 0) motion.velocity = {}, motion.angularVelocity = 0.0f;
        info.flags &= static_cast<std::uint8_t>(~kHasTarget);
    } else if ((info.flags & kCanSleep) != 0) {
        motion.restTime = restTimeAfter(motion, info.reach, restSpeed(step, slot, body), step.dt);
        found.sleepy = found.sleepy || motion.restTime >= world.settings.sleepTime;
    }
    const bool isSwept = info.kind == BodyKind::Dynamic
                             ? isFast({deltaPosition.x, deltaPosition.y}, deltaPosition.z, info)
                             : moved;
    if (isSwept && world.settings.continuous && meetsSome(world, body)) found.fast.push_back(body);
    updateShapes(world, body, found.left);
}

/// Destroys joints whose breakForce or breakTorque was exceeded. Called after keepEnergy.
void breakJoints(StepContext& step) {
    World& world = step.world;
    for (const BreakableJoint& breakable : step.work.joints.breakables) {
        const JointDefinition& definition = world.joints.definition[breakable.joint];
        const auto exceeds = [&](float force, float torque) {
            return breakable.force > force || breakable.torque > torque;
        };
        if (world.joints.hot[breakable.joint].bodyA == kNone) continue;  // already broken
        const JointId id{breakable.joint, world.joints.hot[breakable.joint].generation};
        if (exceeds(definition.reportForce, definition.reportTorque)) world.strainedJoints.push_back(id);
        if (!exceeds(definition.breakForce, definition.breakTorque)) continue;
        world.brokenJoints.push_back(id);
        destroyJoint(world, id);
    }
}

}  // namespace

void finishBodies(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    forPieces(step.pool, world.awake.size(), kFinishGrain, work.bodyFindings,
              [&](std::size_t begin, std::size_t end, BodyFindings& found) {
                  for (std::size_t i = begin; i < end; ++i)
                      finish(step, static_cast<std::size_t>(work.slots[world.awake[i]]), world.awake[i],
                             found);
              });
    work.sleepy = false;
    work.fastBodies.clear();
    for (const BodyFindings& found : work.bodyFindings) {
        for (const std::uint32_t shape : found.left) {
            noteChanged(world, shape);
            noteMoved(world, shape);
        }
        work.sleepy = work.sleepy || found.sleepy;
        work.fastBodies.insert(work.fastBodies.end(), found.fast.begin(), found.fast.end());
        for (const std::uint32_t body : found.broken) world.quarantined.push_back(idOfBody(world, body));
    }
    // Clears impulses on bodies with a non-finite state, because these impulses are not finite either.
    const auto isBroken = [&](std::uint32_t body) {
        return work.slots[body] >= 0 && !isSound(work, static_cast<std::size_t>(work.slots[body]));
    };
    if (!world.quarantined.empty())
        forgetImpulses(step, [&](std::uint32_t a, std::uint32_t b) { return isBroken(a) || isBroken(b); });
    if (step.runs(Effect::Joints))
        breakJoints(step);  // last, because it may wake bodies that were not in this step
}

}  // namespace plumb::physics
