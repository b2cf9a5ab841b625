#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "editor/model/debug/script_place.hpp"

namespace plumb::editor {

/// Returns the first line of a source that a text names: of a script, as "scripts/slime.lua:12", or of C++
/// code, as compilers write it, "code/slime.cpp:12:5: error: ..."; nothing if it names none.
std::optional<ScriptPlace> sourcePlaceIn(std::string_view text);

/// Returns the program and the arguments of a command. Words are separated by spaces; double quotes keep
/// spaces in a word.
/// @param command  "code -g {file}:{line}"; {file} and {line} are replaced inside of words, so that spaces in
///                 the path do no harm. Without {file}, the file is added as the last word
std::vector<std::string> wordsOf(std::string_view command, const Path& file, int line);

/// Opens a line of a source in the user's text editor.
/// @param command  as in `wordsOf`; empty: the program that the system assigns to the file, without the line
/// @param root     folder to which the place is relative
/// @error          the file does not exist, or the program cannot be started
Result<Done> openInTextEditor(std::string_view command, const Path& root, const ScriptPlace& place);

}  // namespace plumb::editor
