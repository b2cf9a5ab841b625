#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

JointBlockKind blockOf(std::uint8_t) { return kHingeBlocks; }

JointParts partsOf(const JointView& view) {
    JointParts parts = anchorsOf(view);
    parts.springs = ownGrip(view, parts.grip);
    parts.angle = angleOf(view);
    parts.value.held = true;
    parts.value.springs = parts.springs;
    parts.value.grip = parts.grip;
    const JointSpring& spring = view.definition.spring;
    if (!spring.on) return parts;
    parts.value.springs = spring.hertz < view.timing.stiffest;
    parts.value.grip = parts.value.springs ? springGrip(spring.hertz, spring.dampingRatio, view.timing.h)
                                           : view.timing.rigid;
    return parts;
}

}  // namespace

extern const JointType kWeldJoint;
const JointType kWeldJoint{"weld", blockOf, partsOf};

}  // namespace plumb::physics
