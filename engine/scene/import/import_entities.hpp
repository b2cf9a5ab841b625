#pragma once

#include <vector>

#include "assets/tiled_map.hpp"
#include "math/rect.hpp"
#include "reflect/json.hpp"
#include "scene/import/import_stage.hpp"
#include "scene/import/import_tiled.hpp"
#include "scene/import/import_tilesets.hpp"
#include "scene/import/tile_animation.hpp"

namespace plumb {

/// Orders of drawing above this are the same for the engine.
inline constexpr int kHighestLayerOrder = 1000;

/// What the entities of a map need to know of everything else.
struct EntityImport {
    const tiled::Map& map;
    const std::vector<ImportedTileset>& tilesets;  ///< as in the map
    ImportStage& stage;
    TileAnimations& animations;
    ImportReport& report;
    Vec2 picture;  ///< px of the game's picture: Tiled moves layers by its middle, the engine by its corner
};

/// The entities of all layers, in the order of drawing, as scene files hold them.
Json importEntities(const EntityImport& import);

/// What the camera may show: the map, or for an endless one the box around its tiles.
Rect boundsOf(const tiled::Map& map);

}  // namespace plumb
