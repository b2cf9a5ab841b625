#pragma once

#include "import/tiled_map.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// Returns the terrains for a tileset file, one for each color of each Wang set. Corner sets become terrains
/// of TerrainMode::Corners, edge sets of Edges, mixed sets of Blob. A tile of several colors belongs to the
/// last of these colors, because where terrains meet, Autotile uses the terrain of the higher id.
/// @return JSON array for the member "terrains"; empty if there are none
Json terrainsOf(const tiled::Tileset& tileset);

}  // namespace plumb
