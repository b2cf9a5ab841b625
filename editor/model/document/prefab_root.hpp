#pragma once

#include <vector>

#include "editor/model/document/document.hpp"
#include "editor/model/document/entity_state.hpp"

namespace plumb::editor {

/// The first entity of the prefab that is open; null while a scene is open. All others are below it, and it
/// stays as long as the prefab is open.
ObjectId prefabRootOf(const Document& document);

/// In an open prefab, what would stand beside its first entity comes below it, at the same place.
void belowPrefabRoot(const Document& document, std::vector<EntityState>& states);

}  // namespace plumb::editor
