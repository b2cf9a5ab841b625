#pragma once

#include "import/tiled_map.hpp"
#include "math/vec2.hpp"
#include "reflect/json.hpp"

namespace plumb {

Json vec2Json(Vec2 vector);
/// Returns "#rrggbb", or "#rrggbbaa" for a color that is not opaque.
Json colorJson(Color color);

/// Returns the fields of a Tiled object, stored in the scene as data because no component has all of them.
Json objectJson(const tiled::Object& object);

}  // namespace plumb
