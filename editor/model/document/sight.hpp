#pragma once

#include <vector>

#include "editor/model/document/document.hpp"

namespace plumb::editor {

// What the view of a document says of an entity, by itself or through those above it.

bool isOutOfSight(const Document& document, ObjectId id);
bool isLocked(const Document& document, ObjectId id);
/// Hidden or locked: the mouse goes through it, and tools leave it where it is.
bool isOutOfHand(const Document& document, ObjectId id);

/// All that is not drawn, sorted; with the tile layers beside one that is shown alone.
std::vector<EntityId> outOfSight(const Document& document);

}  // namespace plumb::editor
