#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// Reports once per name every key of an LDtk project that no reader asks for.
/// @param idle  gets the names of what means something only inside LDtk
void tellUnknownKeys(const Json& project, std::string_view where, std::set<std::string>& idle,
                     std::vector<Error>& problems);

/// The same for a level in a file of its own.
void tellUnknownLevelKeys(const Json& level, std::string_view where, std::set<std::string>& idle,
                          std::vector<Error>& problems);

}  // namespace plumb
