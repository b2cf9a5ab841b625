#pragma once

#include <vector>

#include "tests/accuracy/reference/group.hpp"

namespace plumb::reference {

/// Parts the bodies into those that may touch or are tied in a step of `h` s, by their bounds and by how far
/// they may come in it.
std::vector<Group> findGroups(const Scene& scene, const RunState& state, double h);

}  // namespace plumb::reference
