#pragma once

#include "math/rect.hpp"
#include "platform/image.hpp"

namespace plumb::editor {

/// Returns a part of an image, scaled down by averaging the pixels. The part is first cropped to the center
/// that has the aspect ratio of the thumbnail.
/// @param part  px; clipped to the image
/// @return      an empty image if the part lies outside the image
Image thumbnailOf(const Image& picture, const AABB& part, int width, int height);

}  // namespace plumb::editor
