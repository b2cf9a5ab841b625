#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plumb::editor {

/// A line of a script.
struct ScriptPlace {
    std::string file;  ///< "scripts/slime.lua"
    int line = 0;      ///< from 1

    friend bool operator==(const ScriptPlace&, const ScriptPlace&) = default;
};

/// Returns the first place that a text names as "scripts/slime.lua:12"; nothing if it names none.
std::optional<ScriptPlace> scriptPlaceIn(std::string_view text);

}  // namespace plumb::editor
