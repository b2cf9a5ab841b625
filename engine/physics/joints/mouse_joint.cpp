#include <algorithm>
#include <cmath>

#include "physics/joints/joint_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

// A damped spring of limited force. Source: E. Catto, "Soft Constraints", GDC 2011.

JointBlockKind blockOf(std::uint8_t) { return kHingeBlocks; }

JointParts partsOf(const JointView& view) {
    const JointSpring& spring = view.definition.spring;
    JointParts parts = anchorsOf(view);
    parts.armA = {};
    parts.apart = view.toTarget + parts.armB;
    parts.grip = springGrip(spring.on ? spring.hertz : kDefaultHertz, spring.on ? spring.dampingRatio : 1.0f,
                            view.timing.h);
    parts.springs = true;
    parts.maximum = std::min(view.definition.maxForce * view.timing.h, kNoLimit);
    return parts;
}

}  // namespace

extern const JointType kMouseJoint;
const JointType kMouseJoint{"mouse", blockOf, partsOf};

}  // namespace plumb::physics
