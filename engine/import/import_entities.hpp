#pragma once

#include <string>
#include <vector>

#include "import/import_tilesets.hpp"
#include "import/scene_draft.hpp"
#include "import/tile_animation.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// Highest drawing order the engine distinguishes; higher ones are clamped to it.
inline constexpr int kHighestLayerOrder = 1000;

/// Inputs and outputs of the import of a map's entities.
struct EntityImport {
    const tiled::Map& map;
    const std::vector<ImportedTileset>& tilesets;  ///< parallel to map.tilesets
    TileAnimations& animations;
    SceneDraft& draft;
    std::string key;  ///< prefix of entity keys, distinct for each map of a world; empty for a single map
};

/// Adds the entities of all layers, in drawing order.
void importEntities(const EntityImport& import);

}  // namespace plumb
