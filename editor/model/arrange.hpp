#pragma once

#include <vector>

#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// What of several boxes is brought to one line: that of the box around all of them.
enum class Alignment : unsigned char { Left, Center, Right, Top, Middle, Bottom };

/// Those that are arranged: each once, not below another one of them, not locked, and somewhere.
std::vector<ObjectId> arrangeable(const Document& document, const std::vector<ObjectId>& objects);

/// Moves entities so that their boxes are in line. One step of undo; doing it twice changes nothing more.
/// @return false when nothing had to be moved
bool alignEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects, Alignment to);

/// Makes the gaps between boxes equal, left to right or top to bottom; the first and the last one stay.
bool spreadEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects,
                    bool downwards);

}  // namespace plumb::editor
