#pragma once

#include <optional>
#include <string_view>

namespace plumb {

enum class ImageFormat : unsigned char { Png, Jpeg, Bmp };

/// The header of an image file.
struct ImageHeader {
    ImageFormat format = ImageFormat::Png;
    int width = 0;   ///< px
    int height = 0;  ///< px; as stored in the file, not checked against limits
};

/// Returns the format of a file by its signature; nothing for other formats.
std::optional<ImageFormat> imageFormatOf(std::string_view bytes);

/// Reads the size without decoding anything.
/// @return nothing if the header is truncated or invalid
std::optional<ImageHeader> readImageHeader(std::string_view bytes);

}  // namespace plumb
