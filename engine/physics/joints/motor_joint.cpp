#include <cmath>

#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

JointBlockKind blockOf(std::uint8_t) { return kHingeBlocks; }

JointParts partsOf(const JointView& view) {
    const JointDefinition& definition = view.definition;
    JointParts parts = anchorsOf(view);
    const Vec2 offset = rotate(view.turnA, definition.offset);
    parts.armA += offset;
    parts.apart -= offset;
    parts.springs = ownGrip(view, parts.grip);
    parts.most = std::fmin(definition.maxForce * view.timing.h, kNoLimit);
    parts.angle = angleOf(view);
    parts.value.held = true;
    parts.value.springs = parts.springs;
    parts.value.grip = parts.grip;
    parts.value.most = std::fmin(definition.maxTorque * view.timing.h, kNoLimit);
    return parts;
}

}  // namespace

extern const JointType kMotorJoint;
const JointType kMotorJoint{"motor", blockOf, partsOf};

}  // namespace plumb::physics
