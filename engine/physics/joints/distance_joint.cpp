#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

JointBlockKind blockOf(std::uint8_t) { return kRodBlocks; }

JointParts partsOf(const JointView& view) {
    JointParts parts = anchorsOf(view);
    parts.value = valueParts(view);
    parts.value.rest = view.definition.length;
    if (!view.definition.spring.on && !view.definition.limit.on && !view.definition.motor.on) {
        parts.value.held = true;
        parts.value.springs = ownGrip(view, parts.value.grip);
    }
    return parts;
}

}  // namespace

extern const JointType kDistanceJoint;
const JointType kDistanceJoint{"distance", blockOf, partsOf};

}  // namespace plumb::physics
