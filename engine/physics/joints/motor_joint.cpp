#include <algorithm>
#include <cmath>

#include "physics/joints/joint_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

JointBlockKind blockOf(std::uint8_t) { return kHingeBlocks; }

JointParts drivenParts(const JointView& view) {
    const JointDefinition& definition = view.definition;
    JointParts parts = anchorsOf(view);
    parts.grip = {1.0f, kSteering, 0.0f};
    parts.apart = (-1.0f / kSteering) * rotate(view.turnA, definition.velocity);
    parts.springs = true;
    parts.maximum = std::min(definition.maxForce * view.timing.h, kNoLimit);
    parts.angle = angleOf(view);
    parts.value.driven = true;
    parts.value.speed = definition.motor.speed;
    parts.value.maxMotor = std::min(definition.maxTorque * view.timing.h, kNoLimit);
    return parts;
}

JointParts partsOf(const JointView& view) {
    const JointDefinition& definition = view.definition;
    if (definition.motor.on) return drivenParts(view);
    JointParts parts = anchorsOf(view);
    const Vec2 offset = rotate(view.turnA, definition.offset);
    parts.armA += offset;
    parts.apart -= offset;
    // Soft in both passes: the relax pass must not take back what the limited force corrected.
    const bool own = definition.hertz > 0.0f;
    parts.grip = springGrip(own ? definition.hertz : kDefaultHertz, own ? definition.dampingRatio : 1.0f,
                            view.timing.h);
    parts.springs = true;
    parts.maximum = std::min(definition.maxForce * view.timing.h, kNoLimit);
    parts.angle = angleOf(view);
    parts.value.held = true;
    parts.value.springs = parts.springs;
    parts.value.grip = parts.grip;
    parts.value.maximum = std::min(definition.maxTorque * view.timing.h, kNoLimit);
    return parts;
}

}  // namespace

extern const JointType kMotorJoint;
const JointType kMotorJoint{"motor", blockOf, partsOf};

}  // namespace plumb::physics
