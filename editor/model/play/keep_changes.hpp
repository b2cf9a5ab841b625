#pragma once

#include <span>
#include <string>
#include <vector>

#include "editor/model/play/play_edits.hpp"

namespace plumb::editor {

class UndoStack;

/// A field that the user changed while the game ran, with its value in the scene and in the game.
struct KeepRow {
    PlayEdit edit;
    std::string entity;  ///< name of the entity, e.g. "crate"
    std::string field;   ///< e.g. "Transform.position"
    std::string scene;   ///< value in the scene, as JSON text
    std::string played;  ///< value set by the user in the game, as JSON text
    bool keep = true;    ///< true: ticked, so that it is copied to the scene
};

/// Returns the changes that can be copied from a stopping game to the scene: serialized fields of entities of
/// the scene whose value differs from the scene's. Changes that were undone by rewinding are listed unticked.
std::vector<KeepRow> changesToKeep(Document& document, const World& played, const PlayEdits& edits);

/// Copies the ticked changes to the scene, as one undo step. @return number of copied changes
std::size_t keepChanges(Document& document, UndoStack& undo, std::span<const KeepRow> rows);

}  // namespace plumb::editor
