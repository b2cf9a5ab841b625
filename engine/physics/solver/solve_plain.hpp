#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// What solve() does where StepContext::isPlain(): the same, without all that could not happen.
void solvePlain(StepContext& step);

}  // namespace plumb::physics
