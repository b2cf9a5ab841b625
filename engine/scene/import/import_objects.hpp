#pragma once

#include "scene/import/entity_json.hpp"
#include "scene/import/import_entities.hpp"

namespace plumb {

/// The components of one object: a Sprite for a tile, a Label for a text, a trigger for an upright rectangle
/// or a circle; for other shapes only the place, the rest stays data.
Json objectComponents(const EntityImport& import, const tiled::Layer& layer, const LayerPlace& place,
                      const tiled::Object& object);

}  // namespace plumb
