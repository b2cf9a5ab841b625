#pragma once

#include "tests/accuracy/reference/group.hpp"

namespace plumb::reference {

/// Simulates a scene with steps of about `h` s. Results are in the state; check its `trouble` first.
/// @param deadline  s of wallSeconds(): it gives up then
RunState runScene(const Scene& scene, double seconds, double h, double deadline);

}  // namespace plumb::reference
