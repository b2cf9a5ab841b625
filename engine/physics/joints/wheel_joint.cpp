#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

JointBlockKind blockOf(std::uint8_t) { return kSliderBlocks; }

JointParts partsOf(const JointView& view) {
    JointParts parts = anchorsOf(view);
    parts.axis = rotate(view.turnA, view.definition.axis);
    parts.value = valueParts(view);
    parts.spin = parts.value.speed;
    parts.maxSpin = parts.value.maxMotor;
    parts.value.driven = false;  // the motor drives the rotation, not the translation
    return parts;
}

}  // namespace

extern const JointType kWheelJoint;
const JointType kWheelJoint{"wheel", blockOf, partsOf};

}  // namespace plumb::physics
