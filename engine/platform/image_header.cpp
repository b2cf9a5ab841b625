#include "platform/image_header.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/text.hpp"

// A parser of the engine's own, because the header readers of common libraries trust their input:
// fuzzing that of stb_image found a write beyond the end of a table within seconds.

namespace plumb {
namespace {

constexpr std::string_view kPng{"\x89PNG\r\n\x1a\n", 8};

std::uint32_t byteAt(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

/// Reads an integer in big- or little-endian order. @pre the bytes exist
std::uint32_t big(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | byteAt(bytes, at + i);
    return value;
}
std::uint32_t little(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = count; i > 0; --i) value = value << 8 | byteAt(bytes, at + i - 1);
    return value;
}

std::optional<ImageHeader> headerOf(ImageFormat format, std::uint32_t width, std::uint32_t height) {
    constexpr std::uint32_t kMax = std::numeric_limits<std::int32_t>::max();
    if (width == 0 || height == 0 || width > kMax || height > kMax) return std::nullopt;
    return ImageHeader{format, static_cast<int>(width), static_cast<int>(height)};
}

std::optional<ImageHeader> readPng(std::string_view bytes) {
    if (bytes.size() < 33 || bytes.substr(12, 4) != "IHDR") return std::nullopt;
    return headerOf(ImageFormat::Png, big(bytes, 16, 4), big(bytes, 20, 4));
}

std::optional<ImageHeader> readBmp(std::string_view bytes) {
    if (bytes.size() < 26) return std::nullopt;
    const std::uint32_t headerSize = little(bytes, 14, 4);
    if (headerSize == 12) return headerOf(ImageFormat::Bmp, little(bytes, 18, 2), little(bytes, 20, 2));
    // A negative height means that the rows are top to bottom.
    const std::uint32_t height = little(bytes, 22, 4);
    return headerOf(ImageFormat::Bmp, little(bytes, 18, 4), height > 0x80000000u ? 0u - height : height);
}

/// Skips the segments before the one that contains the size.
std::optional<ImageHeader> readJpeg(std::string_view bytes) {
    std::size_t at = 2;
    while (at + 4 <= bytes.size()) {
        if (byteAt(bytes, at) != 0xff) return std::nullopt;
        const std::uint32_t marker = byteAt(bytes, at + 1);
        if (marker == 0xff) {
            ++at;  // padding
            continue;
        }
        if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {
            at += 2;  // segments without a length
            continue;
        }
        const std::size_t length = big(bytes, at + 2, 2);
        const bool statesSize =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (marker == 0xd9 || marker == 0xda || length < 2) return std::nullopt;
        if (statesSize) {
            if (length < 8 || at + 9 > bytes.size()) return std::nullopt;
            return headerOf(ImageFormat::Jpeg, big(bytes, at + 7, 2), big(bytes, at + 5, 2));
        }
        at += 2 + length;
    }
    return std::nullopt;
}

}  // namespace

std::optional<ImageFormat> imageFormatOf(std::string_view bytes) {
    if (startsWith(bytes, kPng)) return ImageFormat::Png;
    if (startsWith(bytes, "\xff\xd8\xff")) return ImageFormat::Jpeg;
    if (startsWith(bytes, "BM")) return ImageFormat::Bmp;
    return std::nullopt;
}

std::optional<ImageHeader> readImageHeader(std::string_view bytes) {
    const std::optional<ImageFormat> format = imageFormatOf(bytes);
    if (!format) return std::nullopt;
    switch (*format) {
        case ImageFormat::Png: return readPng(bytes);
        case ImageFormat::Jpeg: return readJpeg(bytes);
        case ImageFormat::Bmp: return readBmp(bytes);
    }
    return std::nullopt;
}

}  // namespace plumb
