#pragma once

#include <memory>
#include <vector>

#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// Lets copies stand behind what they are copies of: behind the original and those below it that follow it in
/// the file. The copy of a part of a prefab stands behind the instance; a copy whose original is not there
/// stays where it is.
/// @param copies     in the document, behind all others, parents before their children
/// @param originals  of each of them
void placeCopies(Document& document, const std::vector<ObjectId>& copies,
                 const std::vector<ObjectId>& originals);

/// The way back: lets them stand behind all others again, so that these have the places of before.
void placeAtEnd(Document& document, const std::vector<ObjectId>& copies);

/// Puts copies in, each behind its original, as one step of undo.
/// @param originals  of each of them
void insertCopies(UndoStack& undo, std::unique_ptr<InsertEntities> copies, std::vector<ObjectId> originals);

}  // namespace plumb::editor
