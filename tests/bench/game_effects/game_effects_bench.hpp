#pragma once

#include <cstdint>
#include <string_view>

#include "app/game.hpp"

namespace plumb::bench {

// Each of these functions prints its results and returns an exit code.

/// For each effect (an optional part of the engine), counts the instructions of a tick without its systems,
/// and with its systems added to a scene that does not require it. @return 1 if an unused effect costs more
/// than 1 %, 77 if valgrind is not installed
int measureUnused(const char* program, bool quick);
/// Runs the ticks that measureUnused() counts under valgrind.
int runCountedTicks(bool quick);
/// Measures memory, start time and tick time of each sample project, with the effects that its scenes require
/// and with all effects on.
int measureProjects(bool quick);

}  // namespace plumb::bench
