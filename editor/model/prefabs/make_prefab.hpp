#pragma once

#include <string>
#include <vector>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Returns the path of the file for a prefab of this name, relative to the project.
std::string prefabPath(std::string_view name);

/// Writes an entity and its descendants to the file of a new prefab, and makes them an instance of it.
/// Instances of other prefabs become nested instances. The root's position and rotation, and references to
/// entities outside, are not written to the prefab: the instance keeps them. One undo step, which also
/// deletes the file.
/// @param objects  if several, the outermost ones are first put below a new entity
/// @return the root entity of the instance
/// @error  the file exists, the name is empty, or `objects` has a part of another prefab; then nothing has
///         changed
Result<ObjectId> makePrefab(Workspace& workspace, const std::vector<ObjectId>& objects,
                            const std::string& path);

}  // namespace plumb::editor
