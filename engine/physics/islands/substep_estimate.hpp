#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Automatic quality estimate: additional levels for an island with high mass ratios, stacks or many joints.
[[nodiscard]] int extraQuality(const SubstepEstimate& island);

/// Computes Workspace::hardness of the awake islands, by root. @pre findRoots() was called in this step
void estimateSubsteps(World& world, Workspace& work);

/// Computes Workspace::roots, once per step. Bodies that are not dynamic or are asleep are their own root.
/// @param exact  false: islands that fell apart may still count as one, and nothing of the world changes
void findRoots(const StepContext& step, bool exact = true);

}  // namespace plumb::physics
