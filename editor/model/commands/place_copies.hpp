#pragma once

#include <memory>
#include <vector>

#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// Moves copies in the file order right after their originals and the descendants that follow these. A copy
/// of a part of a prefab instance goes after the instance; a copy whose original is missing stays at the end.
/// @param copies     entities at the end of the document, parents before their children
/// @param originals  original of each copy
void placeCopies(Document& document, const std::vector<ObjectId>& copies,
                 const std::vector<ObjectId>& originals);

/// Reverts placeCopies: moves the copies back to the end, so that all other entities have their old order.
void placeAtEnd(Document& document, const std::vector<ObjectId>& copies);

/// Inserts copies, each after its original, as one undo step.
/// @param originals  original of each copy
void insertCopies(UndoStack& undo, std::unique_ptr<InsertEntities> copies, std::vector<ObjectId> originals);

}  // namespace plumb::editor
