#pragma once

#include <string>
#include <vector>

#include "import/import_tilesets.hpp"
#include "import/scene_draft.hpp"
#include "import/tile_animation.hpp"
#include "import/tiled_map.hpp"
#include "math/rect.hpp"

namespace plumb {

/// Orders of drawing above this are the same for the engine.
inline constexpr int kHighestLayerOrder = 1000;

/// What the entities of a map need to know of everything else.
struct EntityImport {
    const tiled::Map& map;
    const std::vector<ImportedTileset>& tilesets;  ///< as in the map
    TileAnimations& animations;
    SceneDraft& draft;
    std::string key;  ///< tells the map from the others of a world; empty when it is alone
};

/// Adds the entities of all layers, in the order of drawing.
void importEntities(const EntityImport& import);

/// What the camera may show: the map, or for an endless one the box around its tiles.
Rect boundsOf(const tiled::Map& map);

}  // namespace plumb
