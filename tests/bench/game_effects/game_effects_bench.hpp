#pragma once

#include <cstdint>
#include <string_view>

#include "app/game.hpp"

namespace plumb::bench {

// Each prints its table and gives back an exit code.

/// Instructions of a tick without the systems of an effect, and with them present but not required,
/// by callgrind. @return 1 when an unused one costs more than 1 %, 77 when valgrind is not installed
int measureUnused(const char* program, bool quick);
/// What measureUnused() runs under valgrind.
int runCountedTicks(bool quick);
/// Memory, start and tick of each sample project, as its scenes call for effects and with every effect on.
int measureProjects(bool quick);

}  // namespace plumb::bench
