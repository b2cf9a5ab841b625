#pragma once

#include <vector>

#include "editor/model/document/document.hpp"

namespace plumb::editor {

// Editor visibility of entities (EntityView), including that inherited from ancestors.

/// True if the entity or an ancestor is hidden.
bool isHiddenInTree(const Document& document, ObjectId id);
/// True if the entity or an ancestor is locked.
bool isLocked(const Document& document, ObjectId id);
/// True if the entity or an ancestor is hidden or locked: it cannot be picked, and tools do not change it.
bool isHiddenOrLocked(const Document& document, ObjectId id);

/// Returns all entities that are not drawn, sorted: hidden ones, and tile layers while another is shown
/// alone.
std::vector<EntityId> hiddenEntities(const Document& document);

}  // namespace plumb::editor
