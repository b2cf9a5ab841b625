#pragma once

#include <vector>

#include "tests/accuracy/reference/group.hpp"

namespace plumb::reference {

/// Divides the bodies into independent groups: bodies connected by joints or by possible contacts in a step
/// of `h` s. A contact is possible if the bounds, enlarged by the maximum displacement in the step, overlap.
std::vector<Group> findGroups(const Scene& scene, const RunState& state, double h);

}  // namespace plumb::reference
