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

/// Reads the size from the header of an image file. Decodes nothing, so it is cheap and safe.
/// @param where  the file's name, for errors
/// @error empty, not a PNG, JPEG or BMP, larger than the limits, or so large for its number of
/// bytes that it is a decompression bomb
Result<ImageSize> readImageSize(std::string_view bytes, std::string_view where);

/// Decodes an image file.
/// @error those of readImageSize(), or the file is truncated or damaged
Result<Image> decodeImage(std::string_view bytes, std::string_view where);

/// Encodes an image as PNG.
/// @error  an empty image, or one whose pixels do not match its size
Result<std::string> encodePng(const Image& image);

}  // namespace plumb
