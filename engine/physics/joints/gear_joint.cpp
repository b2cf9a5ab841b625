#include "physics/joints/joint_types.hpp"
#include "physics/model/joints.hpp"

namespace plumb::physics {

namespace {

/// Adds the Jacobian of a hinge angle or slider translation, times `ratio`, to the constraint.
void addCoordinate(const World& world, std::uint32_t index, float ratio, NBodyConstraint& constraint) {
    const Joint& joint = world.joints.hot[index];
    if (joint.kind != JointKind::Prismatic) {
        constraint.add({joint.bodyA, 0.0f, 0.0f, -ratio});
        constraint.add({joint.bodyB, 0.0f, 0.0f, ratio});
        return;
    }
    const BodyPose& a = world.bodies.pose[joint.bodyA];
    const BodyPose& b = world.bodies.pose[joint.bodyB];
    const Vec2 axis = ratio * rotate(a.rotation, world.joints.definition[index].axis);
    const Vec2 armB = rotate(b.rotation, joint.anchorB), armA = (b.centre - a.centre) + armB;
    constraint.add({joint.bodyA, -axis.x, -axis.y, -cross(armA, axis)});
    constraint.add({joint.bodyB, axis.x, axis.y, cross(armB, axis)});
}

/// The error is accumulated over all steps since the gear was created (Joint::rows[1]): angles are not
/// limited to one revolution.
NBodyConstraint nBodyConstraintOf(const World& world, const Joint& joint, const JointDefinition& definition) {
    NBodyConstraint constraint;
    if (!alive(world, definition.jointA) || !alive(world, definition.jointB)) return constraint;
    addCoordinate(world, definition.jointA.index, 1.0f, constraint);
    addCoordinate(world, definition.jointB.index, definition.ratio, constraint);
    constraint.error = joint.rows[1];
    return constraint;
}

}  // namespace

extern const JointType kGearJoint;
const JointType kGearJoint{"gear", nullptr, nullptr, nBodyConstraintOf};

}  // namespace plumb::physics
