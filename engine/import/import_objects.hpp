#pragma once

#include "import/entity_json.hpp"
#include "import/import_entities.hpp"

namespace plumb {

/// The components of one object: a Sprite for a tile, a Label for a text, a trigger for an area or a line;
/// the numbers of the original stay as data.
Json objectComponents(const EntityImport& import, const tiled::Layer& layer, const LayerPlace& place,
                      const tiled::Object& object);

/// Whether an object has an outline that no component can hold.
bool isOutlineLost(const tiled::Object& object);

}  // namespace plumb
