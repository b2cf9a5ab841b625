#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

/// Adds one side of the rope.
/// @return its length times `ratio`
float addSide(const World& world, std::uint32_t body, Vec2 anchor, Vec2 ground, float ratio,
              NBodyConstraint& constraint) {
    const BodyPose& pose = world.bodies.pose[body];
    const Vec2 arm = rotate(pose.rotation, anchor);
    const Vec2 rope = (pose.centre - WorldPosition{ground}) + arm;
    const Vec2 along = ratio * normalized(rope);
    constraint.add({body, along.x, along.y, cross(arm, along)});
    return ratio * length(rope);
}

NBodyConstraint nBodyConstraintOf(const World& world, const Joint& joint, const JointDefinition& definition) {
    NBodyConstraint constraint;
    const float a = addSide(world, joint.bodyA, joint.anchorA, definition.groundA, 1.0f, constraint);
    const float b =
        addSide(world, joint.bodyB, joint.anchorB, definition.groundB, definition.ratio, constraint);
    constraint.error = a + b - definition.length;
    return constraint;
}

}  // namespace

extern const JointType kPulleyJoint;
const JointType kPulleyJoint{"pulley", nullptr, nullptr, nBodyConstraintOf};

}  // namespace plumb::physics
