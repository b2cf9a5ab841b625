#pragma once

#include "physics/workspace.hpp"

namespace plumb::physics {

/// How many qualities more an island deserves by what it is made of: high mass ratios, stacks and chains.
[[nodiscard]] int extraQuality(const IslandHardness& island);

/// What the awake islands are made of: Workspace::hardness, by root.
void findHardness(World& world, Workspace& work);

/// The root of the island of a body; what cannot be pushed is alone.
[[nodiscard]] std::uint32_t rootOf(World& world, std::uint32_t body);

}  // namespace plumb::physics
