#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// A name that no prefab of the folder prefabs/ has: the wanted one, or that with a number behind it.
std::string freePrefabName(const Workspace& workspace, std::string_view wanted);

/// What `makePrefab` would make of these that is not plain to see: a variant, or one with instances inside;
/// empty: a plain one.
std::string prefabToBe(const Document& document, const std::vector<ObjectId>& objects);

}  // namespace plumb::editor
