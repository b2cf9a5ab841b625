#include <algorithm>

#include "physics/effects/drag.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/fields.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// Removes the fields of bodies that are gone.
void dropOrphans(World& world) {
    for (std::uint32_t i = 0; i < world.fields.all.size(); ++i) {
        const Field& field = world.fields.all[i];
        const FieldDefinition& d = field.definition;
        const bool isSpring = d.kind == FieldKind::Spring;
        if (!field.isAlive || !(isSpring || (d.kind == FieldKind::Attractor && d.a))) continue;
        if (!alive(world, d.a) || (isSpring && d.b && !alive(world, d.b)))
            destroyField(world, {i, field.generation});
    }
}

void note(const World& world, Workspace& work, std::uint32_t body, std::uint32_t field) {
    const std::int32_t slot = work.slots[body];
    if (slot < 0 || !isDynamic(world, body)) return;
    work.smooth.pulls.push_back({static_cast<std::uint32_t>(slot), field});
}

void findPulls(const World& world, Workspace& work) {
    work.smooth.pulls.clear();
    forFieldsOnBodies(world, work, 0xffffffffu,
                      [&](std::uint32_t body, std::uint32_t f) { note(world, work, body, f); });
    if (!world.manifest.runs(Effect::Springs)) return;
    for (std::uint32_t f = 0; f < world.fields.all.size(); ++f) {
        const FieldDefinition& d = world.fields.all[f].definition;
        if (!world.fields.all[f].isAlive || d.kind != FieldKind::Spring) continue;
        note(world, work, d.a.index, f);
        if (d.b) note(world, work, d.b.index, f);
    }
}

/// Sorts the pulls by slot, and those of one slot by field.
void sortPulls(Workspace& work, bool hasSprings) {
    SmoothForces& smooth = work.smooth;
    smooth.begins.assign(work.bodyOf.size() + 1, 0);
    for (const SmoothForces::Pull& pull : smooth.pulls) ++smooth.begins[pull.slot + 1];
    for (std::size_t i = 1; i < smooth.begins.size(); ++i) smooth.begins[i] += smooth.begins[i - 1];
    smooth.fields.resize(smooth.pulls.size());
    // In reverse, so that pulls of one slot keep their order.
    std::vector<std::uint32_t>& ends = work.bodyScratch;
    ends.assign(smooth.begins.begin() + 1, smooth.begins.end());
    for (std::size_t i = smooth.pulls.size(); i-- > 0;) {
        smooth.fields[--ends[smooth.pulls[i].slot]] = smooth.pulls[i].field;
    }
    if (!hasSprings) return;  // they were found last
    for (std::size_t slot = 0; slot + 1 < smooth.begins.size(); ++slot) {
        const auto begin = smooth.fields.begin();
        std::sort(begin + smooth.begins[slot], begin + smooth.begins[slot + 1]);
    }
}

bool flies(const World& world, const Workspace& work, std::uint32_t body) {
    return work.colourMasks[body] == 0 && !work.softSurroundings.holds(body) &&
           world.bodies.info[body].firstJoint == kNone;
}

/// Ratio by which drag reduces a constant acceleration over a substep, as in gatherBodies().
struct DriveScale {
    float linear = 1.0f;
    float angular = 1.0f;
};

DriveScale scaleOf(const StepContext& step, std::uint32_t body, float h) {
    if (step.work.keep.empty()) return {};
    const BodyDrive& drive = step.world.bodies.driveOf(body);
    return {decayOf(drive.linearDrag, h).drive / h, decayOf(drive.angularDrag, h).drive / h};
}

/// Estimate of another body's state: its state at the start of the step.
BodyState stateNow(const FieldView& view, std::uint32_t body) { return stateAtStart(view.world, body); }

/// Applies fields to a body that contacts or joints hold: the solver uses the force at the start of the step.
void drive(StepContext& step, std::size_t slot, std::uint32_t body, float h) {
    const FieldView view{step.world, step.dt, stateNow};
    const Acceleration pull =
        accelerationAt(view, step.work.smooth.fieldsOf(slot), body, stateAtStart(step.world, body));
    const DriveScale scale = scaleOf(step, body, h);
    Float4& row = step.work.drive[slot];
    row.x += scale.linear * pull.linear.x;
    row.y += scale.linear * pull.linear.y;
    row.z += scale.angular * pull.angular;
}

void launch(StepContext& step, std::size_t slot, std::uint32_t body, float h) {
    SmoothForces& smooth = step.work.smooth;
    const DriveScale scale = scaleOf(step, body, h);
    const Float4& row = step.work.drive[slot];
    Flyer flyer;
    flyer.slot = static_cast<std::uint32_t>(slot);
    flyer.body = body;
    flyer.steady = {{row.x / scale.linear, row.y / scale.linear}, row.z / scale.angular};
    const BodyState start = stateAtStart(step.world, body);
    const FieldView view{step.world, h, stateNow};
    flyer.isSteady = true;
    for (const std::uint32_t& f : smooth.fieldsOf(slot)) {
        if (isConstant(step.world.fields.all[f].definition)) {
            flyer.steady += accelerationAt(view, {&f, 1}, body, start);
        } else {
            flyer.isSteady = false;
        }
    }
    flyer.linearDrag = step.world.bodies.driveOf(body).linearDrag;
    flyer.angularDrag = step.world.bodies.driveOf(body).angularDrag;
    flyer.now = start;
    const std::uint8_t flags = step.world.bodies.info[body].flags;
    if ((flags & kLockX) != 0) flyer.now.velocity.x = flyer.steady.linear.x = 0.0f;
    if ((flags & kLockY) != 0) flyer.now.velocity.y = flyer.steady.linear.y = 0.0f;
    smooth.flyerOf[body] = static_cast<std::int32_t>(smooth.flyers.size());
    smooth.flyers.push_back(flyer);
}

/// Wakes a resting body if the other end of one of its springs moves.
void wakeOtherEnds(World& world) {
    const auto rests = [&](BodyId body) { return isDynamic(world, body.index) && !isUp(world, body.index); };
    const auto moves = [&](BodyId body) {
        const BodyInfo& info = world.bodies.info[body.index];
        return info.place != kNone &&
               (info.kind == BodyKind::Kinematic || world.bodies.motion[body.index].restTime == 0.0f);
    };
    for (const Field& field : world.fields.all) {
        const FieldDefinition& d = field.definition;
        if (!field.isAlive || d.kind != FieldKind::Spring || !d.b) continue;
        if (rests(d.a) && moves(d.b)) wake(world, d.a.index);
        if (rests(d.b) && moves(d.a)) wake(world, d.b.index);
    }
}

}  // namespace

void prepareFields(StepContext& step) {
    dropOrphans(step.world);
    if (step.world.manifest.runs(Effect::Springs)) wakeOtherEnds(step.world);
}

void applyFields(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    SmoothForces& smooth = work.smooth;
    smooth.flyers.clear();
    smooth.flyerOf.assign(world.bodies.size(), -1);
    findPulls(world, work);
    if (smooth.pulls.empty()) return;
    sortPulls(work, world.manifest.runs(Effect::Springs));
    for (const SolveGroup& group : work.groups) {
        const float h = step.dt / static_cast<float>(group.substeps);
        for (auto slot = static_cast<std::size_t>(group.begin); slot < static_cast<std::size_t>(group.end);
             ++slot) {
            if (smooth.fieldsOf(slot).empty()) continue;
            const std::uint32_t body = work.bodyOf[slot];
            flies(world, work, body) ? launch(step, slot, body, h) : drive(step, slot, body, h);
        }
    }
}

}  // namespace plumb::physics
