#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Returns a name not yet used in the folder prefabs/: `wanted`, or `wanted` with a number appended.
std::string freePrefabName(const Workspace& workspace, std::string_view wanted);

/// Returns a note for the user on what `makePrefab` would create: a variant, a new parent entity, or nested
/// instances; empty for a plain prefab.
std::string prefabNote(const Document& document, const std::vector<ObjectId>& objects);

}  // namespace plumb::editor
