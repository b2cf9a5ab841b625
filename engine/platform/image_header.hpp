#pragma once

#include <optional>
#include <string_view>

namespace plumb {

enum class ImageFormat : unsigned char { Png, Jpeg, Bmp };

/// What the first bytes of an image file say.
struct ImageHeader {
    ImageFormat format = ImageFormat::Png;
    int width = 0;   ///< px
    int height = 0;  ///< px; as large as the file states, without any limit
};

/// Which format the file has by its signature; nothing for all others.
std::optional<ImageFormat> imageFormatOf(std::string_view bytes);

/// Reads the size without decoding anything.
/// @return nothing when the header is cut off or senseless
std::optional<ImageHeader> readImageHeader(std::string_view bytes);

}  // namespace plumb
