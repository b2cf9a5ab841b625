#pragma once

#include <string>
#include <string_view>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Errors of the last load and save, shown until the user dismisses them or a later try succeeds. A resource
/// of the document's world.
struct Problems {
    std::string load;  ///< why the requested scene could not be opened
    std::string save;  ///< why the last save failed
};
Problems& problemsOf(Workspace& workspace);

/// Returns why the active tile tool cannot paint at this point; empty if it can.
/// @param at  px, in world space
std::string_view whyNotPainted(const Workspace& workspace, Vec2 at);

/// Returns the path of a new scene file.
/// @error  the name is empty, contains a slash or leaves the folder, or a scene of that name exists
Result<Path> newSceneFile(const Path& project, std::string_view name);

/// Notice in the status bar when a game starts.
inline constexpr std::string_view kPlayingNotice = "Playing";

}  // namespace plumb::editor
