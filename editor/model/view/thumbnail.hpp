#pragma once

#include "math/rect.hpp"
#include "platform/image.hpp"

namespace plumb::editor {

/// A part of a picture, made smaller by the mean of what lies under each pixel. Of the part the middle is
/// taken that has the shape wanted.
/// @param part  px; what is outside the picture is left out
/// @return      empty when nothing of the picture is in the part
Image thumbnailOf(const Image& picture, const AABB& part, int width, int height);

}  // namespace plumb::editor
