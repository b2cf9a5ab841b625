#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

// Never awake, so never solved: addAwakeJoint().
extern const JointType kFilterJoint;
const JointType kFilterJoint{"filter", [](std::uint8_t) { return kRodBlocks; }, anchorsOf};

}  // namespace plumb::physics
