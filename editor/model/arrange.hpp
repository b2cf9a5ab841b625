#pragma once

#include <vector>

#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// Edge or center line of the entities' boxes that alignEntities() makes equal to that of their common box.
enum class Alignment : unsigned char { Left, Center, Right, Top, Middle, Bottom };

/// Returns the entities of the list that can be arranged: not locked, with a Transform, not the root of an
/// open prefab, and not below another entity of the list.
std::vector<ObjectId> arrangeable(const Document& document, const std::vector<ObjectId>& objects);

/// Aligns the boxes of entities, as one undo step.
/// @return false if no entity had to move
bool alignEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects, Alignment to);

/// Makes the gaps between the boxes equal, along x or (`downwards`) along y. The first and the last box stay.
bool spreadEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects,
                    bool downwards);

}  // namespace plumb::editor
