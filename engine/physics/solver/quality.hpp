#pragma once

#include "physics/settings.hpp"

namespace plumb::physics {

struct World;
struct Workspace;

/// Divides the awake bodies into groups of islands that are solved alike: Workspace::groups, and solveOrder
/// unless there is one group. An island takes the highest quality of its members, the world's included; with
/// Settings::tolerance, what its errors call for.
void sortByQuality(World& world, Workspace& work);

constexpr int substepsOf(Quality quality) { return 1 << quality; }

}  // namespace plumb::physics
