#pragma once

#include "tests/accuracy/reference/group.hpp"

namespace plumb::reference {

/// Simulates a scene with time steps of about `h` s. The result is invalid if RunState::trouble is not empty.
/// @param deadline  value of wallSeconds() at which the run stops with an error, s
RunState runScene(const Scene& scene, double seconds, double h, double deadline);

}  // namespace plumb::reference
