#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// What a project of Tiled says of its classes: the properties that everything of a class has, and their
/// values where a file does not say others. By name; properties in the form that `tmxProperties` gives.
using TiledClasses = std::map<std::string, Json, std::less<>>;

/// Reads a `.tiled-project`. What is wrong inside is reported and left out.
TiledClasses readTiledClasses(std::string_view text, std::string_view where, std::vector<Error>& warnings);

/// The classes of the project around a map: of the first `.tiled-project` in its folder or one of those
/// around it. Empty when there is none.
TiledClasses tiledClassesAround(const Path& map, std::vector<Error>& warnings);

/// Gives everything in the map that has a class the properties that its file leaves to the class.
void applyClasses(tiled::Map& map, const TiledClasses& classes);

}  // namespace plumb
