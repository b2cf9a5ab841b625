#pragma once

#include "physics/workspace.hpp"

namespace plumb::physics {

/// Finds which of the joints that are awake are solved directly, and in which order: trees of bodies, from
/// what they hang on outwards. Follows from the joints alone, so a restored world grows the same trees.
void growTrees(World& world, Workspace& work);

/// True when trees are solved directly in this step.
inline bool solvesTrees(const World& world, const Workspace& work) {
    return work.joints.trees.some && world.manifest.runs(Effect::Joints);
}
/// True when all that acts on a body are joints that are solved directly in this step.
inline bool isInTree(const World& world, const Workspace& work, std::uint32_t body) {
    return solvesTrees(world, work) && work.colourMasks[body] != 0 &&
           work.colourMasks[body] == work.joints.trees.freeMasks[body];
}

}  // namespace plumb::physics
