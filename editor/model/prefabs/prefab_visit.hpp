#pragma once

#include <optional>
#include <string>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

// A prefab is opened for editing like a scene. Leaving it returns to the file from which it was opened. Each
// opened file has its own undo history.

/// True if the open file is a prefab.
bool editsPrefab(const Workspace& workspace);
/// Returns the path of the prefab that the selected instances or parts belong to; empty if there is none, or
/// several.
std::string selectedPrefab(const Workspace& workspace);

/// Opens a prefab's file for editing. @error  it cannot be read; the file that was open before stays open
Result<LoadReport> editPrefab(Workspace& workspace, const std::string& path);
/// Returns the file that `leavePrefab` opens: the scene or prefab from which this prefab was opened,
/// otherwise the first scene; empty if there is none.
std::string fileToReturnTo(const Workspace& workspace);
/// Opens the file that `fileToReturnTo` returns, with its former view and selection.
Result<LoadReport> leavePrefab(Workspace& workspace);
/// Leaves all prefabs back to the scene, and plays it. @param paused  pauses before the first tick
void playSceneBehind(Workspace& workspace, bool paused);

// Requests: the window executes them after the user decided about unsaved changes.

/// A request to open a prefab, to leave one, or to play the scene from which it was opened.
struct PrefabVisit {
    enum class Kind : unsigned char { Edit, Leave, Play, PlayPaused };
    Kind kind = Kind::Edit;
    std::string path;  ///< path of the prefab, for `Kind::Edit`
};
void askToEditPrefab(Workspace& workspace, std::string path);
void askToLeavePrefab(Workspace& workspace);
void askToPlayScene(Workspace& workspace, bool paused);
/// Returns and clears the pending request.
std::optional<PrefabVisit> takePrefabVisit(Workspace& workspace);
/// Executes a request.
void go(Workspace& workspace, const PrefabVisit& visit);

}  // namespace plumb::editor
