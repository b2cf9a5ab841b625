#pragma once

#include <string>

#include "import/import_entities.hpp"

namespace plumb {

/// Adds colliders for the tiles of a layer whose cells are smaller than its tiles, so that the collision
/// shapes do not fit in the cells: an entity for each shape, at the place of its tile, all below one entity.
/// @param key  prefix of the entities' keys, distinct for each layer
void addTileColliders(const EntityImport& import, const tiled::Layer& layer, const LayerPlacement& place,
                      const std::string& key);

}  // namespace plumb
