#pragma once

#include <string>
#include <vector>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// The path of a new prefab's file, for a name that a person typed.
std::string prefabPath(std::string_view name);

/// Writes an entity and all below it into the file of a new prefab, and makes them its instance. What is an
/// instance of another prefab stays one inside it. Where the entity stands is its own; references to entities
/// outside stay with it. One step of undo, which takes the file away again.
/// @param objects  of several, those that are outermost are put below a new entity first
/// @return the instance's first entity
/// @error  there is such a file, no name, or a part of another prefab is among them; nothing has changed then
Result<ObjectId> makePrefab(Workspace& workspace, const std::vector<ObjectId>& objects,
                            const std::string& path);

}  // namespace plumb::editor
