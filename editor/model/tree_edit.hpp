#pragma once

#include <string>
#include <vector>

#include "editor/model/commands/reparent.hpp"
#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// Destination of moved entities in the tree.
struct TreePlace {
    ObjectId parent;      ///< null: no parent
    ObjectId beside{};    ///< child of `parent` next to which the entities go; null: the order stays
    bool behind = false;  ///< after `beside` instead of before it
};

/// Moves entities with their descendants in the tree, as one undo step. Skips parts of prefab instances, and
/// entities that would become their own descendant.
/// @return false if nothing moves
bool moveInTree(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects,
                const TreePlace& place, KeepPlace keep = KeepPlace::InWorld);

/// Makes entities children of a new entity. The new entity is placed at the center of their boxes, and in the
/// tree at the row of the first of them. One undo step.
/// @return the new entity, which gets selected; null if none of the entities can be moved
ObjectId groupEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects);

/// Moves an entity one row up (-1) or down (1) among its siblings. @return false if it cannot move
bool stepInTree(Document& document, UndoStack& undo, ObjectId object, int by);

}  // namespace plumb::editor
