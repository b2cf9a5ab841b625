#pragma once

#include <string>
#include <string_view>

namespace plumb::editor {

class Workspace;

/// Returns the current keys of an action ("Ctrl+Z"), or its label ("Undo") if it has none, to be inserted
/// into a sentence such as "{} removes it".
std::string keysFor(const Workspace& workspace, std::string_view action);

/// Replaces every action id in braces by the current keys of the action: "{edit.delete} removes the corner"
/// becomes "Delete removes the corner".
std::string withKeys(const Workspace& workspace, std::string_view sentence);

}  // namespace plumb::editor
