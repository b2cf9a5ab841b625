#pragma once

#include "import/tiled_map.hpp"
#include "math/vec2.hpp"
#include "reflect/json.hpp"

namespace plumb {

Json vec2Json(Vec2 vector);
/// "#rrggbb", or "#rrggbbaa" when it is not opaque.
Json colorJson(Color color);

/// What a scene has no component for is kept as data: the shape and the numbers of an object as Tiled has
/// them.
Json objectJson(const tiled::Object& object);

}  // namespace plumb
