#pragma once

#include <string>
#include <string_view>

namespace plumb::editor {

class Workspace;

/// The keys of an action as the person has them now, "Ctrl+Z"; where it has none its name, "Undo". For
/// sentences: "{} takes it back".
std::string keysFor(const Workspace& workspace, std::string_view action);

/// A sentence of a table with the keys of the person in it: "{edit.delete} takes it out".
std::string withKeys(const Workspace& workspace, std::string_view sentence);

}  // namespace plumb::editor
