#pragma once

#include <vector>

#include "tests/accuracy/reference/group.hpp"

namespace plumb::reference {

/// Divides the bodies into groups that may touch or have joints in a
/// step of `h` s, by their bounds and the maximum displacement in it.
std::vector<Group> findGroups(const Scene& scene, const RunState& state, double h);

}  // namespace plumb::reference
