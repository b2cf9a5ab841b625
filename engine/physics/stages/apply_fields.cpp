#include <algorithm>

#include "physics/effects/drag.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/fields.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// Removes the springs and attractors of destroyed bodies.
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

/// Sorts the pulls by slot and field.
void sortPulls(Workspace& work, bool hasSprings) {
    SmoothForces& smooth = work.smooth;
    smooth.begins.assign(work.bodyOf.size() + 1, 0);
    for (const SmoothForces::Pull& pull : smooth.pulls) ++smooth.begins[pull.slot + 1];
    for (std::size_t i = 1; i < smooth.begins.size(); ++i) smooth.begins[i] += smooth.begins[i - 1];
    smooth.fields.resize(smooth.pulls.size());
    // In reverse, so that the pulls of a slot keep their order.
    std::vector<std::uint32_t>& ends = work.bodyScratch;
    ends.assign(smooth.begins.begin() + 1, smooth.begins.end());
    for (std::size_t i = smooth.pulls.size(); i-- > 0;)
        smooth.fields[--ends[smooth.pulls[i].slot]] = smooth.pulls[i].field;
    if (!hasSprings) return;  // springs were appended last
    for (std::size_t slot = 0; slot + 1 < smooth.begins.size(); ++slot) {
        const auto begin = smooth.fields.begin();
        std::sort(begin + smooth.begins[slot], begin + smooth.begins[slot + 1]);
    }
}

/// True for a body without contacts, joints and soft bodies on it.
bool isFree(const World& world, const Workspace& work, std::uint32_t body) {
    return work.colourMasks[body] == 0 && !work.softSurroundings.holds(body) &&
           world.bodies.info[body].firstJoint == kNone;
}

/// Returns the factors by which gatherBodies() scales constant accelerations because of drag.
DriveScale scaleOf(const StepContext& step, std::uint32_t body, float h) {
    if (step.work.keep.empty()) return {};
    const BodyDrive& drive = step.world.bodies.driveOf(body);
    return {decayOf(drive.linearDrag, h).drive / h, decayOf(drive.angularDrag, h).drive / h};
}

/// Calls act(slot, body, h) for the bodies on which fields act; h (s) is their substep.
template <class Act>
void forPulledSlots(const StepContext& step, Act&& act) {
    for (const SolveGroup& group : step.work.groups) {
        const float h = step.dt / static_cast<float>(group.substeps);
        for (auto slot = static_cast<std::size_t>(group.begin); slot < static_cast<std::size_t>(group.end);
             ++slot) {
            if (!step.work.smooth.fieldsOf(slot).empty()) act(slot, step.work.bodyOf[slot], h);
        }
    }
}

bool hasChangingFields(const StepContext& step, std::size_t slot) {
    const std::span<const std::uint32_t> fields = step.work.smooth.fieldsOf(slot);
    return std::any_of(fields.begin(), fields.end(),
                       [&](std::uint32_t f) { return !isConstant(step.world.fields.all[f].definition); });
}

/// Selects the FieldMotion of each body. Bodies with springs to a driven body are driven too: the force at
/// both ends of a spring must be computed from the same states, or momentum is lost.
void chooseMotions(StepContext& step) {
    std::vector<FieldMotion>& motions = step.work.smooth.motions;
    motions.assign(step.work.bodyOf.size(), FieldMotion::Steady);
    std::vector<std::uint32_t>& driven = step.work.bodyScratch;  // slots whose springs must be visited
    driven.clear();
    forPulledSlots(step, [&](std::size_t slot, std::uint32_t body, float) {
        if (isFree(step.world, step.work, body)) {
            motions[slot] = FieldMotion::Free;
        } else if (hasChangingFields(step, slot)) {
            motions[slot] = FieldMotion::Driven;
            driven.push_back(static_cast<std::uint32_t>(slot));
        }
    });
    while (step.world.manifest.runs(Effect::Springs) && !driven.empty()) {
        const std::uint32_t slot = driven.back();
        driven.pop_back();
        for (const std::uint32_t f : step.work.smooth.fieldsOf(slot)) {
            const FieldDefinition& field = step.world.fields.all[f].definition;
            if (field.kind != FieldKind::Spring) continue;
            const BodyId end = field.a.index == step.work.bodyOf[slot] ? field.b : field.a;
            const std::int32_t other =
                end && isDynamic(step.world, end.index) ? step.work.slots[end.index] : -1;
            if (other < 0 || motions[static_cast<std::size_t>(other)] == FieldMotion::Driven) continue;
            motions[static_cast<std::size_t>(other)] = FieldMotion::Driven;
            driven.push_back(static_cast<std::uint32_t>(other));
        }
    }
}

/// Computes springScales. A spring is stable if the total stiffness of the springs at its two ends is at most
/// 1 (Gershgorin's bound for a net of springs).
void softenSprings(StepContext& step) {
    SmoothForces& smooth = step.work.smooth;
    std::vector<float>& scales = smooth.springScales;
    scales.assign(step.world.fields.all.size(), 0.0f);
    forPulledSlots(step, [&](std::size_t slot, std::uint32_t body, float h) {
        const auto isSpring = [&](std::uint32_t f) {
            return step.world.fields.all[f].definition.kind == FieldKind::Spring;
        };
        float sum = 0.0f;
        for (const std::uint32_t f : smooth.fieldsOf(slot)) {
            if (isSpring(f)) sum += springStiffness(step.world, step.world.fields.all[f].definition, body, h);
        }
        for (const std::uint32_t f : smooth.fieldsOf(slot)) {
            if (isSpring(f)) scales[f] += sum;
        }
    });
    for (float& scale : scales) scale = 1.0f / std::max(1.0f, scale);
}

/// Returns the acceleration of a body by gravity, applied forces and constant fields.
Acceleration steadyAcceleration(const StepContext& step, std::size_t slot, std::uint32_t body, float h,
                                const DriveScale& scale) {
    const Float4& row = step.work.drive[slot];
    Acceleration steady{{row.x / scale.linear, row.y / scale.linear}, row.z / scale.angular};
    const FieldView view{step.world, h};
    for (const std::uint32_t f : step.work.smooth.fieldsOf(slot)) {
        const FieldDefinition& field = step.world.fields.all[f].definition;
        if (!isConstant(field)) continue;
        steady +=
            fieldTypeOf(field.kind).force(view, f, body, stateAfter(step.world, body, 0.0f)).acceleration;
    }
    steady.linear = unlocked(step.world, body, steady.linear);
    return steady;
}

void setDrive(StepContext& step, std::size_t slot, const DriveScale& scale, const Acceleration& all) {
    Float4& row = step.work.drive[slot];
    row.x = scale.linear * all.linear.x;
    row.y = scale.linear * all.linear.y;
    row.z = scale.angular * all.angular;
}

void launch(StepContext& step, std::size_t slot, std::uint32_t body, const Acceleration& steady) {
    SmoothForces& smooth = step.work.smooth;
    FreeBody flyer{.slot = static_cast<std::uint32_t>(slot),
                   .body = body,
                   .steady = steady,
                   .isSteady = !hasChangingFields(step, slot),
                   .linearDrag = step.world.bodies.driveOf(body).linearDrag,
                   .angularDrag = step.world.bodies.driveOf(body).angularDrag,
                   .now = stateAfter(step.world, body, 0.0f)};
    flyer.now.velocity = unlocked(step.world, body, flyer.now.velocity);
    smooth.flyerOf[body] = static_cast<std::int32_t>(smooth.flyers.size());
    smooth.flyers.push_back(flyer);
}

/// Wakes a resting body if the other end of one of its springs moves.
void wakeOtherEnds(World& world) {
    const auto rests = [&](BodyId body) { return isDynamic(world, body.index) && !isUp(world, body.index); };
    const auto moves = [&](BodyId body) {
        const BodyInfo& info = world.bodies.info[body.index];
        return info.awakeIndex != kNone &&
               (info.kind == BodyKind::Kinematic || world.bodies.motion[body.index].restTime == 0.0f);
    };
    for (const Field& field : world.fields.all) {
        const FieldDefinition& d = field.definition;
        if (!field.isAlive || d.kind != FieldKind::Spring || !d.b) continue;
        if (rests(d.a) && moves(d.b)) wake(world, d.a.index);
        if (rests(d.b) && moves(d.a)) wake(world, d.b.index);
    }
}

/// Context of stateInSolver(): a group while its substeps are solved.
struct Solved {
    const Workspace& work;
    const SolveGroup& group;
};

BodyState stateInSolver(const FieldView& view, std::uint32_t body) {
    const auto& [work, group] = *static_cast<const Solved*>(view.flight);
    const std::int32_t slot = work.slots[body];
    if (slot < group.begin || slot >= group.end) return stateAfter(view.world, body, view.elapsed);
    const BodyPose& pose = view.world.bodies.pose[body];
    const auto row = static_cast<std::size_t>(slot);
    if (group.withoutRotation) {
        const Float4& state = work.statesWithoutRotation[row];
        return {pose.centre + Vec2{state.z, state.w}, pose.rotation, {state.x, state.y}, 0.0f};
    }
    const Float4 &velocity = work.velocity[row], &moved = work.deltaPosition[row];
    const Rot rotation = normalized(Rot{1.0f + moved.w, moved.z} * pose.rotation);
    return {pose.centre + Vec2{moved.x, moved.y}, rotation, {velocity.x, velocity.y}, velocity.z};
}

/// Calls act(driven) for the driven bodies of a group.
template <class Act>
void forDriven(Workspace& work, const SolveGroup& group, Act&& act) {
    for (Driven& driven : work.smooth.driven) {
        const auto slot = static_cast<std::int32_t>(driven.slot);
        if (slot >= group.begin && slot < group.end) act(driven);
    }
}

/// Returns the work (J) of the current accelerations over a displacement.
float workOver(const StepContext& step, const Driven& driven, const Acceleration& displacement) {
    const BodyMass& mass = step.world.bodies.mass[driven.body];
    const Float4& row = step.work.drive[driven.slot];
    return mass.mass * dot({row.x, row.y}, displacement.linear) + mass.inertia * row.z * displacement.angular;
}

void noteWork(const StepContext& step, Driven& driven) {
    const Float4& now = step.work.deltaPosition[driven.slot];
    const Acceleration moved{{now.x, now.y}, now.z};
    driven.work += workOver(step, driven, moved - driven.moved);
    driven.moved = moved;
}

}  // namespace

void driveBodies(StepContext& step, const SolveGroup& group, float h, float elapsed) {
    const SmoothForces& smooth = step.work.smooth;
    const Solved solved{step.work, group};
    const FieldView view{step.world, h, smooth.springScales, stateInSolver, &solved, elapsed};
    forDriven(step.work, group, [&](Driven& driven) {
        noteWork(step, driven);
        Acceleration all = driven.steady;
        all += accelerationAt(view, smooth.fieldsOf(driven.slot), driven.body,
                              stateInSolver(view, driven.body), driven.steady);
        setDrive(step, driven.slot, driven.scale, all);
    });
}

void finishDriving(StepContext& step, const SolveGroup& group) {
    step.work.smooth.works.resize(step.work.bodyOf.size());
    forDriven(step.work, group, [&](Driven& driven) {
        noteWork(step, driven);
        step.work.smooth.works[driven.slot] = driven.work - workOver(step, driven, driven.moved);
    });
}

void prepareFields(StepContext& step) {
    dropOrphans(step.world);
    if (step.world.manifest.runs(Effect::Springs)) wakeOtherEnds(step.world);
}

void applyFields(StepContext& step) {
    World& world = step.world;
    SmoothForces& smooth = step.work.smooth;
    smooth.flyers.clear();
    smooth.flyerOf.assign(world.bodies.size(), -1);
    findPulls(world, step.work);
    if (smooth.pulls.empty()) return;
    sortPulls(step.work, world.manifest.runs(Effect::Springs));
    chooseMotions(step);
    if (world.manifest.runs(Effect::Springs)) softenSprings(step);
    forPulledSlots(step, [&](std::size_t slot, std::uint32_t body, float h) {
        const DriveScale scale = scaleOf(step, body, h);
        const Acceleration steady = steadyAcceleration(step, slot, body, h, scale);
        if (smooth.motions[slot] == FieldMotion::Free) return launch(step, slot, body, steady);
        setDrive(step, slot, scale, steady);
        if (smooth.motions[slot] == FieldMotion::Driven)
            smooth.driven.push_back({static_cast<std::uint32_t>(slot), body, steady, scale});
    });
}

}  // namespace plumb::physics
