#pragma once

#include "import/entity_json.hpp"
#include "import/import_entities.hpp"

namespace plumb {

/// Returns the components of a Tiled object: a Sprite for a tile, a Label for a text, otherwise a trigger
/// collider.
Json objectComponents(const EntityImport& import, const tiled::Layer& layer, const LayerPlacement& place,
                      const tiled::Object& object);

/// True if an object's outline has too many corners for a collider, so that it is not imported.
bool isOutlineLost(const tiled::Object& object);

}  // namespace plumb
