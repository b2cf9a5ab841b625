#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "platform/image.hpp"

namespace plumb {

struct ImageSize {
    int width = 0;   ///< px
    int height = 0;  ///< px

    friend bool operator==(ImageSize, ImageSize) = default;
};

/// The size that an image file states in its header. Decodes nothing, so it is cheap and safe.
/// @param where  the file's name, for errors
/// @error empty, not a PNG, JPEG or BMP, larger than the limits, or so large for its number of
/// bytes that it is a decompression bomb
Result<ImageSize> readImageSize(std::string_view bytes, std::string_view where);

/// Decodes an image file.
/// @error as readImageSize, or the file is truncated or damaged
Result<Image> decodeImage(std::string_view bytes, std::string_view where);

/// Encodes a picture as PNG.
/// @error  an empty picture, or one whose pixels do not match its size
Result<std::string> encodePng(const Image& image);

}  // namespace plumb
