#pragma once

#include <string>
#include <string_view>

#include "app/module.hpp"
#include "app/player_options.hpp"

namespace plumb {

// An exported game is a player with a file named kPackName beside it, which contains the folders kGameFolder
// (the project) and "assets" (those of the engine).
inline constexpr std::string_view kPackName = "game.pack";
inline constexpr std::string_view kGameFolder = "game";

/// Returns the name of a program of an export: the export gives the player the name of the game. Empty for
/// the player as it was built.
/// @param program  argv[0]
/// @param built    name of the player in the build
std::string exportedName(std::string_view program, std::string_view built);

/// Runs plumb-player with these options: plays a project,
/// runs the benchmark, or lists the effects of a scene.
/// @param code  code of the project that is linked into this program
/// @return the program's exit code; not 0 if the project, its code or its first scene has errors, which are
/// logged
int playProject(const PlayerOptions& options, const Module& code);

}  // namespace plumb
