#include <utility>

#include "physics/solver/joint_lanes.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

void colourJoints(StepContext& step) {
    World& world = step.world;
    refreshColours(world, step.work);
    if (std::exchange(world.newJoints, false)) {
        for (const std::uint32_t index : world.joints.awake) {
            Joint& joint = world.joints.hot[index];
            if (joint.colour != kNoColour) continue;
            const auto [a, b] = pushedBodies(world, joint);
            joint.colour = b != kNone ? takeColour(step.work, a, b) : takeColour(step.work, kNone, a);
        }
    }
    growTrees(world, step.work);
}

}  // namespace plumb::physics
