#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

JointBlockKind blockOf(std::uint8_t) { return kSliderBlocks; }

JointParts partsOf(const JointView& view) {
    JointParts parts = anchorsOf(view);
    parts.axis = rotate(view.turnA, view.definition.axis);
    parts.value = valueParts(view);
    parts.angle = angleOf(view);
    parts.holdsAngle = true;
    return parts;
}

}  // namespace

extern const JointType kPrismaticJoint;
const JointType kPrismaticJoint{"prismatic", blockOf, partsOf};

}  // namespace plumb::physics
