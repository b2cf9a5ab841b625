#include "physics/solver/joint_lanes.hpp"
#include "physics/trees/joint_tree_builder.hpp"

namespace plumb::physics {

void colourJoints(StepContext& step) {
    refreshColours(step.world, step.work);
    colourNewJoints(step.world, step.work);
    growTrees(step.world, step.work);
}

}  // namespace plumb::physics
