#include <algorithm>

#include "physics/joints/joint_types.hpp"
#include "physics/solver/joint_lanes.hpp"

namespace plumb::physics {

namespace {

Float4& velocityAt(Workspace& work, const NBodyConstraint& constraint, int i) {
    return work.velocity[static_cast<std::size_t>(constraint.slots[i])];
}

float speedOf(Workspace& work, const NBodyConstraint& constraint) {
    float speed = 0.0f;
    for (int i = 0; i < constraint.count; ++i) {
        const Float4& v = velocityAt(work, constraint, i);
        speed += v.x * constraint.ends[i].x + v.y * constraint.ends[i].y + v.z * constraint.ends[i].angle;
    }
    return speed;
}

void push(Workspace& work, const NBodyConstraint& constraint, float impulse) {
    for (int i = 0; i < constraint.count; ++i) {
        Float4& v = velocityAt(work, constraint, i);
        if (v.w == 0.0f) continue;
        v.x += v.w * (impulse * constraint.ends[i].x);
        v.y += v.w * (impulse * constraint.ends[i].y);
        v.z += constraint.inverseInertia[i] * (impulse * constraint.ends[i].angle);
    }
}

float errorNow(const Workspace& work, const NBodyConstraint& constraint) {
    float error = constraint.error;
    for (int i = 0; i < constraint.count; ++i) {
        const Float4& deltaPosition = work.deltaPosition[static_cast<std::size_t>(constraint.slots[i])];
        error += deltaPosition.x * constraint.ends[i].x + deltaPosition.y * constraint.ends[i].y +
                 arcTangent(deltaPosition.z, 1.0f + deltaPosition.w) * constraint.ends[i].angle;
    }
    return error;
}

}  // namespace

void addTie(StepContext& step, std::uint32_t index, std::uint8_t group) {
    const World& world = step.world;
    Workspace& work = step.work;
    const Joint& joint = world.joints.hot[index];
    NBodyConstraint constraint =
        jointType(joint.kind).constraint(world, joint, world.joints.definition[index]);
    float response = 0.0f;
    int kept = 0;
    for (int i = 0; i < constraint.count; ++i) {
        const NBodyJacobian end = constraint.ends[i];
        if (work.slots[end.body] < 0) continue;
        const BodyMass& mass = world.bodies.mass[end.body];
        if (end.body == joint.bodyB) constraint.reported = kept;
        constraint.slots[kept] = work.slots[end.body];
        constraint.inverseInertia[kept] = mass.inverseInertia;
        constraint.ends[kept++] = end;
        response +=
            mass.inverseMass * (end.x * end.x + end.y * end.y) + mass.inverseInertia * end.angle * end.angle;
    }
    constraint.count = kept;
    if (response == 0.0f) return;
    constraint.mass = 1.0f / response;
    constraint.impulse = joint.rows[0] * step.dt / static_cast<float>(work.groups[group].substeps);
    constraint.joint = index;
    constraint.group = group;
    work.joints.nBodyConstraints.push_back(constraint);
}

void solveTies(Workspace& work, const JointPass& pass, const SolveGroup& group, PassKind kind) {
    for (NBodyConstraint& constraint : work.joints.nBodyConstraints) {
        if (&work.groups[constraint.group] != &group) continue;
        if (kind == PassKind::WarmStart) {
            push(work, constraint, constraint.impulse);
            continue;
        }
        const Grip grip = kind == PassKind::Push ? pass.rigid : Grip{1.0f, 0.0f, 0.0f};
        const float maximum = grip.speedScale * pass.pushSpeed;  // as for other joints
        const float pull = std::clamp(grip.errorRate * errorNow(work, constraint), -maximum, maximum);
        const float wanted = grip.speedScale * speedOf(work, constraint) + pull;
        const float change = -(constraint.mass * wanted + grip.impulseScale * constraint.impulse);
        constraint.impulse += change;
        push(work, constraint, change);
    }
}

void storeTies(StepContext& step) {
    for (const NBodyConstraint& constraint : step.work.joints.nBodyConstraints) {
        const float force =
            constraint.impulse * static_cast<float>(step.work.groups[constraint.group].substeps) / step.dt;
        const NBodyJacobian& end = constraint.ends[constraint.reported];
        Joint& joint = step.world.joints.hot[constraint.joint];
        joint.rows[0] = force;
        joint.rows[1] = errorNow(step.work, constraint);
        joint.force = force * Vec2{end.x, end.y};
        joint.torque = force * end.angle;
        if ((joint.flags & kBreakable) != 0) {
            step.work.joints.breakables.push_back(
                {constraint.joint, kJointBlockKinds, 0, 0, length(joint.force), std::fabs(joint.torque)});
        }
    }
}

}  // namespace plumb::physics
