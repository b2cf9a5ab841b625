#pragma once

#include "tests/accuracy/reference/group.hpp"

namespace plumb::reference {

/// Simulates a scene with steps of about `h` s. The result is invalid if RunState::trouble is not empty.
/// @param deadline  time of wallSeconds() at which the run stops, s
RunState runScene(const Scene& scene, double seconds, double h, double deadline);

}  // namespace plumb::reference
