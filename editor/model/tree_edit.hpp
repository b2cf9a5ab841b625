#pragma once

#include <string>
#include <vector>

#include "editor/model/commands/reparent.hpp"
#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// Where something comes to in the tree.
struct TreePlace {
    ObjectId parent;      ///< none: beside those that have none
    ObjectId beside{};    ///< one of the parent's children; none: among them, where the file has it
    bool behind = false;  ///< behind that one, not before it
};

/// Moves entities in the tree; what is below them goes with them. One step of undo.
/// Parts of prefabs stay where their prefab has them, and nothing becomes a child of itself.
/// @return false when nothing was to be moved
bool moveInTree(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects,
                const TreePlace& place, KeepPlace keep = KeepPlace::InWorld);

/// Puts entities below a new one in the middle of them, in the place of the first of them. One step of undo.
/// @return the new one, which is selected; null when there is nothing to put below it
ObjectId groupEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects);

/// One place up (-1) or down (1) among those with the same parent. @return false when there is none
bool stepInTree(Document& document, UndoStack& undo, ObjectId object, int by);

}  // namespace plumb::editor
