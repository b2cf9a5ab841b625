#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "platform/image.hpp"

namespace plumb::editor {

/// Returns a smaller square picture: each of its pixels is the mean of those that it covers, weighted by
/// their opacity.
/// @param image  square
/// @param side   px, not more than that of the image
Image shrunk(const Image& image, int side);

/// Returns an icon file for Windows (.ico) with a square picture in the sizes that Windows shows, as far as
/// they are not larger than the picture.
/// @param where  the picture's file, for errors
/// @error        the picture is not square, or smaller than 16 px
/// Source: Microsoft, "The format of icon resources"; its pictures may be PNG files since Windows Vista
Result<std::string> iconFile(const Image& picture, std::string_view where);

}  // namespace plumb::editor
