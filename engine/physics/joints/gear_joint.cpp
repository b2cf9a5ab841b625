#include "physics/joints.hpp"
#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

/// Adds the Jacobian of a hinge angle or slider translation, times `ratio`, to the constraint.
void addCoordinate(const World& world, std::uint32_t index, float ratio, Tie& tie) {
    const Joint& joint = world.joints.hot[index];
    if (joint.kind != JointKind::Prismatic) {
        tie.add({joint.bodyA, 0.0f, 0.0f, -ratio});
        tie.add({joint.bodyB, 0.0f, 0.0f, ratio});
        return;
    }
    const BodyPose& a = world.bodies.pose[joint.bodyA];
    const BodyPose& b = world.bodies.pose[joint.bodyB];
    const Vec2 axis = ratio * rotate(a.rotation, world.joints.definition[index].axis);
    const Vec2 armB = rotate(b.rotation, joint.anchorB), armA = (b.centre - a.centre) + armB;
    tie.add({joint.bodyA, -axis.x, -axis.y, -cross(armA, axis)});
    tie.add({joint.bodyB, axis.x, axis.y, cross(armB, axis)});
}

/// The error is accumulated over all steps since the gear was created (Joint::rows[1]): angles are not
/// limited to one revolution.
Tie tieOf(const World& world, const Joint& joint, const JointDefinition& definition) {
    Tie tie;
    if (!alive(world, definition.jointA) || !alive(world, definition.jointB)) return tie;
    addCoordinate(world, definition.jointA.index, 1.0f, tie);
    addCoordinate(world, definition.jointB.index, definition.ratio, tie);
    tie.error = joint.rows[1];
    return tie;
}

}  // namespace

extern const JointType kGearJoint;
const JointType kGearJoint{"gear", nullptr, nullptr, tieOf};

}  // namespace plumb::physics
