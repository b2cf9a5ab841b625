#pragma once

#include "tests/accuracy/reference/group.hpp"

namespace plumb::reference {

/// Simulates a scene with steps of about `h` s. What became of it is in the state; look at its trouble first.
/// @param deadline  s of wallSeconds(): it gives up then
RunState runScene(const Scene& scene, double seconds, double h, double deadline);

}  // namespace plumb::reference
