#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// Returns entities and all their descendants as JSON text for the clipboard, to be pasted in any scene.
std::string copyAsText(Document& document, const std::vector<ObjectId>& objects);

/// Result of reading a clipboard text.
struct Pasted {
    std::unique_ptr<InsertEntities> command;  ///< null: the text holds no entities, or `why` is set
    std::vector<ObjectId> originals;          ///< ids of the entities in the text, in the same order
    std::vector<std::string> unpacked;        ///< paths of prefabs that this project lacks
    std::string why;                          ///< reason why the entities cannot be pasted here; else empty
};

/// Makes a command that inserts copies of the entities in a text made by `copyAsText`. Instances of prefabs
/// that this project lacks, and parts that this project's version of a prefab lacks, become plain entities,
/// because saving would lose them; a missing prefab is logged as a warning.
Pasted pasteFromText(const PrefabEdit& edit, std::string_view text);

}  // namespace plumb::editor
