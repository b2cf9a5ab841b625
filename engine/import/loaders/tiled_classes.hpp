#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// Default properties of the classes of a Tiled project, by class name. A map stores only values that differ
/// from them. The properties have the form returned by `tmxProperties`.
using TiledClasses = std::map<std::string, Json, std::less<>>;

/// Reads a `.tiled-project`. Invalid parts are reported and ignored.
TiledClasses readTiledClasses(std::string_view text, std::string_view where, std::vector<Error>& warnings);

/// Reads the classes of the project of a map: of the nearest `.tiled-project` in its folder or up to three
/// folders above. Empty if there is none.
TiledClasses tiledClassesAround(const Path& map, std::vector<Error>& warnings);

/// Adds the default properties of their class to all items of a map, where the map does not set them.
void applyClasses(tiled::Map& map, const TiledClasses& classes);

}  // namespace plumb
