#pragma once

#include "physics/settings.hpp"

namespace plumb::physics {

struct StepContext;

/// Divides the awake bodies into groups of islands that are solved with equal parameters: Workspace::groups,
/// and solveOrder unless there is only one group. An island takes the highest quality of its members and the
/// world; with Settings::tolerance, the one that its errors call for. An island in which nothing can rotate
/// is solved by reduced kernels, which give the same bits.
void sortByQuality(StepContext& step);

constexpr int substepsOf(Quality quality) { return 1 << quality; }

}  // namespace plumb::physics
