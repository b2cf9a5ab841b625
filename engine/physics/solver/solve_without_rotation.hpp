#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Solves the groups without rotation: the same bits, without the terms that are zero.
void solveWithoutRotation(StepContext& step);

}  // namespace plumb::physics
