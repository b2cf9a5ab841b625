#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "editor/model/commands/insert_entities.hpp"

namespace plumb::editor {

/// Entities as text that other scenes, other editors and people can read.
std::string copyAsText(Document& document, const std::vector<ObjectId>& objects);

/// A command that puts in what `copyAsText` made; nothing when the text is something else.
std::unique_ptr<InsertEntities> pasteFromText(Document& document, std::string_view text);

}  // namespace plumb::editor
