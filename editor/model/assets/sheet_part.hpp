#pragma once

#include "math/rect.hpp"

namespace plumb::editor {

/// The part of a picture that a small square can show so that one sees what it is: all of it, or the
/// beginning of a long strip, such as the first frames of a sheet.
/// @param size  px of the whole picture
Rect legiblePart(Vec2 size);

}  // namespace plumb::editor
