#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

JointBlockKind blockOf(std::uint8_t) { return kRodBlocks; }

JointParts partsOf(const JointView& view) { return anchorsOf(view); }

}  // namespace

extern const JointType kGearJoint;
const JointType kGearJoint{"gear", blockOf, partsOf};

}  // namespace plumb::physics
