#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// Reports unknown keys of an LDtk project, each name once.
/// @param editorKeys  receives the names of known keys that only LDtk uses
void reportUnknownKeys(const Json& project, std::string_view where, std::set<std::string>& editorKeys,
                       std::vector<Error>& problems);

/// Reports unknown keys of an LDtk level that is stored in its own file.
void reportUnknownLevelKeys(const Json& level, std::string_view where, std::set<std::string>& editorKeys,
                            std::vector<Error>& problems);

}  // namespace plumb
