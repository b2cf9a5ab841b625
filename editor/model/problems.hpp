#pragma once

#include <string>
#include <string_view>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// What went wrong with files, until the person has read it or it went well. Lies beside the document, which
/// outlives what is opened in it.
struct Problems {
    std::string load;  ///< why the scene that was asked for is not open
    std::string save;  ///< why the last save failed
};
Problems& problemsOf(Workspace& workspace);

/// Why a stroke of the tile tool in hand paints nothing there; empty when it paints.
/// @param at  px, world
std::string_view whyNotPainted(const Workspace& workspace, Vec2 at);

/// Where a new scene of that name would be.
/// @error  no name, one that leaves the folder, or there is such a scene
Result<Path> newSceneFile(const Path& project, std::string_view name);

/// The notice of a game that has just begun.
inline constexpr std::string_view kPlayingNotice = "Playing";

}  // namespace plumb::editor
