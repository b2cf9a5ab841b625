#pragma once

#include "app/player_options.hpp"

namespace plumb {

/// What plumb-player does: plays a project, or measures, or lists what a scene calls for.
/// @return the program's exit code
int playProject(const PlayerOptions& options);

}  // namespace plumb
