#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// Entities as text that other scenes, other editors and people can read.
std::string copyAsText(Document& document, const std::vector<ObjectId>& objects);

/// What came of a text that is to be pasted.
struct Pasted {
    std::unique_ptr<InsertEntities> command;  ///< null: the text is something else, or it cannot be put in
    std::vector<ObjectId> originals;          ///< of each entity of it, wherever that is
    std::vector<std::string> unpacked;        ///< prefabs that this project does not have
    std::string why;                          ///< it cannot be put in; empty
};

/// A command that puts in what `copyAsText` made. Instances of prefabs that this project does not have become
/// plain entities, and so do parts that its prefab does not have: else saving would lose them. The console
/// says so.
Pasted pasteFromText(const PrefabEdit& edit, std::string_view text);

}  // namespace plumb::editor
