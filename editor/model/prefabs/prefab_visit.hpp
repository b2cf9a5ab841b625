#pragma once

#include <optional>
#include <string>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

// A prefab is opened like a scene, and left to where one came from. Its document has an undo of its own.

/// Whether a prefab is open.
bool editsPrefab(const Workspace& workspace);
/// The prefab of what is selected, or of its instance; empty when that is none, or several.
std::string prefabInHand(const Workspace& workspace);

/// Opens a prefab's file for editing. @error  it cannot be read; what was open before is open again
Result<LoadReport> editPrefab(Workspace& workspace, const std::string& path);
/// Where `leavePrefab` goes: the scene or the prefab one came from, else the first scene; empty: nowhere.
std::string behindPrefab(const Workspace& workspace);
/// Goes back one step, to where one looked and what was selected.
Result<LoadReport> leavePrefab(Workspace& workspace);
/// Goes back to the scene and plays it. @param paused  before the first tick
void playSceneBehind(Workspace& workspace, bool paused);

// What is asked for; the window does it once the person said what becomes of unsaved changes.

/// Opening a prefab, going back from one, or playing the scene behind it.
struct PrefabVisit {
    enum class Kind : unsigned char { Edit, Leave, Play, PlayPaused };
    Kind kind = Kind::Edit;
    std::string path;  ///< of the prefab, for Edit
};
void askToEditPrefab(Workspace& workspace, std::string path);
void askToLeavePrefab(Workspace& workspace);
void askToPlayScene(Workspace& workspace, bool paused);
/// What was asked for, once.
std::optional<PrefabVisit> takePrefabVisit(Workspace& workspace);
void go(Workspace& workspace, const PrefabVisit& visit);

}  // namespace plumb::editor
