#pragma once

#include "physics/workspace.hpp"

namespace plumb::physics {

/// Decides which awake joints are solved directly and in which order: builds trees of bodies, outwards from
/// the static or kinematic body that they hang on. The trees depend on the joints alone, so a restored world
/// has the same ones.
void growTrees(World& world, Workspace& work);

/// True if some tree is solved directly in this step.
inline bool solvesTrees(const World& world, const Workspace& work) {
    return work.joints.trees.some && world.manifest.runs(Effect::Joints);
}
/// True if all constraints of a body are joints that are solved directly in this step.
inline bool isInTree(const World& world, const Workspace& work, std::uint32_t body) {
    return solvesTrees(world, work) && work.colourMasks[body] != 0 &&
           work.colourMasks[body] == work.joints.trees.freeMasks[body];
}

}  // namespace plumb::physics
