#pragma once

#include <span>
#include <string>
#include <vector>

#include "editor/model/play/play_edits.hpp"

namespace plumb::editor {

class UndoStack;

/// A field that was set by hand while the game played, beside what the scene says.
struct KeepRow {
    PlayEdit edit;
    std::string entity;  ///< "crate"
    std::string field;   ///< "Transform.position"
    std::string scene;   ///< its value in the scene, as in the file
    std::string played;  ///< what it was set to
    bool keep = true;
};

/// What a game that stops can leave to the scene: what is of this scene, is saved, and differs from it.
/// What was set in a time that was then rewound is offered, but not ticked.
std::vector<KeepRow> changesToKeep(Document& document, const World& played, const PlayEdits& edits);

/// Sets the ticked ones in the scene, as one step of undo. @return how many
std::size_t keepChanges(Document& document, UndoStack& undo, std::span<const KeepRow> rows);

}  // namespace plumb::editor
