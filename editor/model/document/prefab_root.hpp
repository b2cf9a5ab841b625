#pragma once

#include <vector>

#include "editor/model/document/document.hpp"
#include "editor/model/document/entity_state.hpp"

namespace plumb::editor {

/// Returns the root entity of the open prefab, null while a scene is open. It cannot be removed.
ObjectId prefabRootOf(const Document& document);

/// In an open prefab, makes new entities without a parent children of its root, keeping their world poses.
void belowPrefabRoot(const Document& document, std::vector<EntityState>& states);

}  // namespace plumb::editor
