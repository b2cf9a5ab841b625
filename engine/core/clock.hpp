#pragma once

#include <cstdint>

namespace plumb {

/// Seconds since some fixed moment, never going back. For the loop, logs and measurements; never for the simulation.
double wallSeconds();

/// Seconds of CPU that this thread has used.
double threadSeconds();

}  // namespace plumb
