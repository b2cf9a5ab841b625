#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// solve() where StepContext::isWithoutRotation(): the same bits, without the terms that are zero.
void solvePlain(StepContext& step);

}  // namespace plumb::physics
