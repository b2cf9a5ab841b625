#pragma once

#include "math/rect.hpp"

namespace plumb::editor {

/// Returns the part of an image to show in a small square thumbnail: all of it, or the start of a long strip
/// (e.g. the first frames of a sheet).
/// @param size  size of the whole image, px
Rect legiblePart(Vec2 size);

}  // namespace plumb::editor
