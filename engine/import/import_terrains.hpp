#pragma once

#include "import/tiled_map.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// Terrains of a tileset file, one for each color of each Wang set. Corner sets become terrains by corners,
/// edge sets by edges, mixed ones blobs. A tile of several colors belongs to the last of them: where terrains
/// meet, Autotile lets the higher id decide.
/// @return a list for the member "terrains"; empty when there are none
Json terrainsOf(const tiled::Tileset& tileset);

}  // namespace plumb
