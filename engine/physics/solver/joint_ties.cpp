#include "physics/solver/joint_ties.hpp"

#include <cmath>

#include "math/portable.hpp"
#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

Float4& velocityAt(Workspace& work, const Tie& tie, int i) {
    return work.velocity[static_cast<std::size_t>(tie.slots[i])];
}

float speedOf(Workspace& work, const Tie& tie) {
    float speed = 0.0f;
    for (int i = 0; i < tie.count; ++i) {
        const Float4& v = velocityAt(work, tie, i);
        speed += v.x * tie.ends[i].x + v.y * tie.ends[i].y + v.z * tie.ends[i].turn;
    }
    return speed;
}

void push(Workspace& work, const Tie& tie, float impulse) {
    for (int i = 0; i < tie.count; ++i) {
        Float4& v = velocityAt(work, tie, i);
        if (v.w == 0.0f) continue;
        v.x += v.w * (impulse * tie.ends[i].x);
        v.y += v.w * (impulse * tie.ends[i].y);
        v.z += tie.inverseInertia[i] * (impulse * tie.ends[i].turn);
    }
}

float errorNow(const Workspace& work, const Tie& tie) {
    float error = tie.error;
    for (int i = 0; i < tie.count; ++i) {
        const Float4& shift = work.shift[static_cast<std::size_t>(tie.slots[i])];
        error += shift.x * tie.ends[i].x + shift.y * tie.ends[i].y +
                 arcTangent(shift.z, 1.0f + shift.w) * tie.ends[i].turn;
    }
    return error;
}

}  // namespace

void addTie(StepContext& step, std::uint32_t index, std::uint8_t group) {
    const World& world = step.world;
    Workspace& work = step.work;
    const Joint& joint = world.joints.hot[index];
    Tie tie = jointType(joint.kind).tie(world, joint, world.joints.definition[index]);
    float response = 0.0f;
    int kept = 0;
    for (int i = 0; i < tie.count; ++i) {
        const TieEnd end = tie.ends[i];
        if (work.slots[end.body] < 0) continue;
        const BodyMass& mass = world.bodies.mass[end.body];
        if (end.body == joint.bodyB) tie.reported = kept;
        tie.slots[kept] = work.slots[end.body];
        tie.inverseInertia[kept] = mass.inverseInertia;
        tie.ends[kept++] = end;
        response +=
            mass.inverseMass * (end.x * end.x + end.y * end.y) + mass.inverseInertia * end.turn * end.turn;
    }
    tie.count = kept;
    if (response <= 0.0f) return;
    tie.mass = 1.0f / response;
    tie.impulse = joint.rows[0] * step.dt / static_cast<float>(work.groups[group].substeps);
    tie.joint = index;
    tie.group = group;
    work.joints.ties.push_back(tie);
}

void solveTies(Workspace& work, const JointPass& pass, const SolveGroup& group, JointAct act) {
    for (Tie& tie : work.joints.ties) {
        if (&work.groups[tie.group] != &group) continue;
        if (act == JointAct::WarmStart) {
            push(work, tie, tie.impulse);
            continue;
        }
        const Grip grip = act == JointAct::Push ? pass.rigid : Grip{1.0f, 0.0f, 0.0f};
        const float wanted = grip.take * speedOf(work, tie) + grip.pull * errorNow(work, tie);
        const float change = -(tie.mass * wanted + grip.give * tie.impulse);
        tie.impulse += change;
        push(work, tie, change);
    }
}

void storeTies(StepContext& step) {
    for (const Tie& tie : step.work.joints.ties) {
        const float force = tie.impulse * static_cast<float>(step.work.groups[tie.group].substeps) / step.dt;
        const TieEnd& end = tie.ends[tie.reported];
        Joint& joint = step.world.joints.hot[tie.joint];
        joint.rows[0] = force;
        joint.rows[1] = errorNow(step.work, tie);
        joint.force = force * Vec2{end.x, end.y};
        joint.torque = force * end.turn;
        if ((joint.flags & kBreakable) != 0) {
            step.work.joints.breakables.push_back(
                {tie.joint, kJointBlockKinds, 0, 0, length(joint.force), std::fabs(joint.torque)});
        }
    }
}

}  // namespace plumb::physics
