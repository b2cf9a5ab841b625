#pragma once

#include <cstdint>
#include <string_view>

#include "app/game.hpp"

namespace plumb::bench {

// Each of these functions prints its results and returns an exit code.

/// Counts the instructions of a tick without the systems of an effect, and with the systems added but not
/// required. @return 1 if an unused effect costs more than 1 %, 77 if valgrind is not installed
int measureUnused(const char* program, bool quick);
/// Runs the ticks that measureUnused() counts under valgrind.
int runCountedTicks(bool quick);
/// Measures memory, start time and tick time of each sample project, with the effects that its scenes require
/// and with all effects on.
int measureProjects(bool quick);

}  // namespace plumb::bench
