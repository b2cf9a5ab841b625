#pragma once

#include <string>
#include <vector>

#include "import/import_tilesets.hpp"
#include "import/scene_draft.hpp"

namespace plumb {

/// Makes pictures for the tiles of a hexagonal map that are turned by 60 or 120 degrees, since cells can only
/// flip tiles. All tiles that a layer has of the same tileset go to one further tileset with them, so that
/// they keep their order of drawing. Cells of the map afterwards have no turns, only flips.
/// @param flat      the orthogonal form of the map; gets the further tilesets
/// @param tilesets  parallel to flat.tilesets
/// @param key       distinct for each map of an import
void addTurnedTiles(tiled::Map& flat, std::vector<ImportedTileset>& tilesets, SceneDraft& draft,
                    const std::string& key);

}  // namespace plumb
