#pragma once

#include "physics/workspace.hpp"

namespace plumb::physics {

/// How many qualities more an island deserves by what it is made of: high mass ratios, stacks and chains.
[[nodiscard]] int extraQuality(const IslandHardness& island);

/// What the awake islands are made of: Workspace::hardness, by root. Their roots are known.
void findHardness(World& world, Workspace& work);

/// Finds Workspace::roots, once in a step: what cannot be pushed, or is asleep, is alone.
void findRoots(World& world, Workspace& work);

}  // namespace plumb::physics
