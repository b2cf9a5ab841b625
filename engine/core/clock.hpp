#pragma once

#include <cstdint>

namespace plumb {

/// Monotonic time in seconds. For the loop, logs and measurements; never for the simulation.
double wallSeconds();

/// CPU time used by this thread, in seconds.
double threadSeconds();

}  // namespace plumb
