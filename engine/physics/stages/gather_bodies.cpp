#include "physics/effects/drag.hpp"
#include "physics/islands/quality.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

constexpr int kGatherGrain = 512;

/// Returns the exact displacement of free flight over h: (x, y) + z * (velocity at the end).
Float4 flightOf(const Float4& drive, const Decay& decay, float drag, float h) {
    // x = v0 D + a (h - D) / k with D = decay.drive; v1 = v0 keep + a D. Without drag: x = v1 h - a h2 / 2.
    // Below 2^-20, v0 is lost in the rounding of v1, so the body moves at v1 all the time.
    if (decay.keep < 0x1p-20f) return {0.0f, 0.0f, h, 0.0f};
    const float along = decay.drive / decay.keep;
    const float rest = distanceUnder(drag, h) - decay.drive * along;
    return {rest * drive.x, rest * drive.y, along, 0.0f};
}

/// True for bodies in free flight: no contacts, and no joints except those in trees. For resting bodies the
/// closed form would add an upward velocity.
bool isFree(const World& world, const Workspace& work, std::uint32_t body) {
    return (work.colourMasks[body] == 0 || isInTree(world, work, body)) && !work.softSurroundings.holds(body);
}

void gatherBody(World& world, Workspace& work, Vec2 gravity, std::uint32_t body, std::size_t slot, float h) {
    const BodyMotion& motion = world.bodies.motion[body];
    const BodyMass& mass = world.bodies.mass[body];
    work.slots[body] = static_cast<std::int32_t>(slot);
    work.bodyOf[slot] = body;
    work.velocity[slot] = {motion.velocity.x, motion.velocity.y, motion.angularVelocity, mass.inverseMass};
    work.deltaPosition[slot] = {};
    work.drive[slot] = {};
    work.ballisticDrift[slot] = {0.0f, 0.0f, h, 0.0f};
    if (mass.inverseMass == 0.0f) return;
    Vec2 pull = gravity;
    float spin = 0.0f;
    if (const std::uint32_t own = world.bodies.info[body].drive; own != kNone) {
        BodyDrive& drive = world.bodies.drives.rows[own];
        pull = drive.gravityScale * gravity + drive.acceleration + mass.inverseMass * drive.force;
        spin = mass.inverseInertia * drive.torque;
        drive.force = {};
        drive.torque = 0.0f;
    }
    work.drive[slot] = {pull.x, pull.y, spin, 0.0f};
    if (isFree(world, work, body)) work.ballisticDrift[slot] = flightOf(work.drive[slot], {1.0f, h}, 0.0f, h);
}

void applyDrag(const World& world, Workspace& work, std::uint32_t body, std::size_t slot, float h) {
    const BodyDrive& drive = world.bodies.driveOf(body);
    work.keep[slot] = {1.0f, 1.0f, 1.0f, 1.0f};
    if (drive.linearDrag == 0.0f && drive.angularDrag == 0.0f) return;
    if (world.bodies.mass[body].inverseMass == 0.0f) return;  // static or kinematic: no drag
    const Decay linear = decayOf(drive.linearDrag, h), angular = decayOf(drive.angularDrag, h);
    if (isFree(world, work, body))
        work.ballisticDrift[slot] = flightOf(work.drive[slot], linear, drive.linearDrag, h);
    work.keep[slot] = {linear.keep, linear.keep, angular.keep, 1.0f};
    work.drive[slot].x *= linear.drive / h;
    work.drive[slot].y *= linear.drive / h;
    work.drive[slot].z *= angular.drive / h;
}

void makeRoom(StepContext& step, std::size_t slots) {
    Workspace& work = step.work;
    work.slots.assign(step.world.bodies.size(), -1);
    work.bodyOf.assign(slots, kNone);
    work.smooth.driven.clear();
    work.smooth.works.clear();
    work.smooth.motions.clear();
    // Eight additional idle slots for SIMD lanes without a body.
    const std::size_t count = slots + kLanes;
    for (std::vector<Float4>* array : {&work.velocity, &work.deltaPosition, &work.drive, &work.ballisticDrift,
                                       &work.velocityBeforeImpulses}) {
        array->resize(count);
    }
    work.keep.resize(step.starts(Effect::Drag) ? count : 0);
}

void clearSlot(Workspace& work, std::size_t slot) {
    work.velocity[slot] = work.deltaPosition[slot] = work.drive[slot] = work.ballisticDrift[slot] =
        work.velocityBeforeImpulses[slot] = {};
    if (!work.keep.empty()) work.keep[slot] = {};
}

}  // namespace

void gatherBodies(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    refreshColours(world, work);
    sortByQuality(step);
    sortIntoStrips(step);
    std::size_t slots = 0;
    for (SolveGroup& group : work.groups) {
        group.begin = static_cast<std::int32_t>(slots);
        slots += (static_cast<std::size_t>(group.bodies) + kLanes - 1) / kLanes * kLanes;
        group.end = static_cast<std::int32_t>(slots);
    }
    makeRoom(step, slots);
    const Vec2 gravity = step.starts(Effect::Gravity) ? world.settings.gravity : Vec2{};
    for (std::size_t idle = slots; idle < slots + kLanes; ++idle) clearSlot(work, idle);
    const std::uint32_t* order = work.solveOrder.empty() ? world.awake.data() : work.solveOrder.data();
    for (const SolveGroup& group : work.groups) {
        const float h = step.dt / static_cast<float>(group.substeps);
        const auto begin = static_cast<std::size_t>(group.begin);
        const auto bodies = static_cast<std::size_t>(group.bodies);
        forEach(step.pool, static_cast<std::size_t>(group.end) - begin, kGatherGrain, [&](std::size_t i) {
            if (i >= bodies) return clearSlot(work, begin + i);
            gatherBody(world, work, gravity, order[i], begin + i, h);
            if (!work.keep.empty()) applyDrag(world, work, order[i], begin + i, h);
        });
        order += group.bodies;
    }
}

}  // namespace plumb::physics
