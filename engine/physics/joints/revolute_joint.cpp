#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

JointBlockKind blockOf(std::uint8_t flags) {
    return (flags & (kLimited | kDriven | kSprung | kSoft)) != 0 ? kHingeBlocks : kPointBlocks;
}

JointParts partsOf(const JointView& view) {
    JointParts parts = anchorsOf(view);
    if (blockOf(view.joint.flags) == kPointBlocks) return parts;  // avoids a read of the definition
    parts.springs = ownGrip(view, parts.grip);
    parts.value = valueParts(view);
    parts.angle = angleOf(view);
    return parts;
}

}  // namespace

extern const JointType kRevoluteJoint;
const JointType kRevoluteJoint{"revolute", blockOf, partsOf};

}  // namespace plumb::physics
