#include "platform/image_file.hpp"

#include <cstring>
#include <memory>
#include <optional>

#include <SDL_image.h>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "platform/image_header.hpp"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace plumb {
namespace {

/// Decoded images up to this size are never treated as decompression bombs: blank ones compress very well.
constexpr std::size_t kHarmlessBytes = std::size_t{64} << 20;

constexpr std::string_view kRemedy = "save it again as PNG";

using Surface = std::unique_ptr<SDL_Surface, decltype(&SDL_FreeSurface)>;

/// Limit on scans: a progressive JPEG may require any number of passes over the whole image.
constexpr int kMaxScans = 64;

bool hasTooManyScans(std::string_view bytes) {
    constexpr std::string_view kScan = "\xff\xda";
    int scans = 0;
    for (std::size_t at = bytes.find(kScan); at != std::string_view::npos; at = bytes.find(kScan, at + 2))
        ++scans;
    return scans > kMaxScans;
}

SDL_Surface* load(ImageFormat format, SDL_RWops* stream) {
    switch (format) {
        case ImageFormat::Png: return IMG_LoadPNG_RW(stream);
        case ImageFormat::Jpeg: return IMG_LoadJPG_RW(stream);
        case ImageFormat::Bmp: return IMG_LoadBMP_RW(stream);
    }
    return nullptr;
}

Error imageError(std::string_view where, std::string what, std::string_view remedy = kRemedy) {
    return {std::string{where}, std::move(what), std::string{remedy}};
}

Image imageOf(SDL_Surface& surface) {
    Image image{surface.w, surface.h, {}};
    const auto rowBytes = static_cast<std::size_t>(surface.w) * 4;
    image.rgba.resize(rowBytes * static_cast<std::size_t>(surface.h));
    for (int y = 0; y < surface.h; ++y) {
        const auto* row =
            static_cast<const std::uint8_t*>(surface.pixels) + static_cast<std::ptrdiff_t>(y) * surface.pitch;
        std::memcpy(image.rgba.data() + static_cast<std::size_t>(y) * rowBytes, row, rowBytes);
    }
    return image;
}

}  // namespace

Result<ImageSize> readImageSize(std::string_view bytes, std::string_view where) {
    if (bytes.empty()) return imageError(where, "the file is empty");
    if (bytes.size() > limits::kFileBytes)
        return imageError(where, "the file is too large", "make it smaller");
    if (!imageFormatOf(bytes)) return imageError(where, "the file is not a PNG, JPEG or BMP image");
    const std::optional<ImageHeader> header = readImageHeader(bytes);
    if (!header) return imageError(where, "the image has a damaged header");
    const ImageSize size{header->width, header->height};
    if (size.width > limits::kImageSide || size.height > limits::kImageSide) {
        return imageError(where,
                          format("the image has {}x{} px, the limit is {} a side", size.width, size.height,
                                 limits::kImageSide),
                          "make it smaller or split it into several images");
    }
    const std::size_t decoded =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4;
    if (decoded > limits::kImageBytes ||
        (decoded > kHarmlessBytes && decoded / bytes.size() > limits::kCompressionRatio)) {
        return imageError(
            where, format("the image would take {} bytes, from a file of {} bytes", decoded, bytes.size()),
            "make it smaller or split it into several images");
    }
    return size;
}

Result<Image> decodeImage(std::string_view bytes, std::string_view where) {
    const Result<ImageSize> size = readImageSize(bytes, where);
    if (!size) return size.error();
    const ImageFormat kind = *imageFormatOf(bytes);
    if (kind == ImageFormat::Jpeg && hasTooManyScans(bytes))
        return imageError(where, format("the JPEG has more than {} scans", kMaxScans));
    // Use only the loader of that format: SDL_image would try others that guess, some without limits.
    SDL_RWops* stream = SDL_RWFromConstMem(bytes.data(), static_cast<int>(bytes.size()));
    const Surface loaded{load(kind, stream), &SDL_FreeSurface};
    SDL_RWclose(stream);
    if (!loaded) return imageError(where, format("the image is damaged or truncated ({})", IMG_GetError()));
    if (ImageSize{loaded->w, loaded->h} != *size)
        return imageError(where, "the decoded size differs from the header");
    const Surface converted{SDL_ConvertSurfaceFormat(loaded.get(), SDL_PIXELFORMAT_RGBA32, 0),
                            &SDL_FreeSurface};
    if (!converted) return imageError(where, format("the image could not be converted ({})", SDL_GetError()));
    return imageOf(*converted);
}

Result<std::string> encodePng(const Image& image) {
    const auto expected = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    if (image.width <= 0 || image.height <= 0 || image.width > limits::kImageSide ||
        image.height > limits::kImageSide || image.rgba.size() != expected) {
        return Error{
            "image",
            format("an image of {}x{} px cannot have {} bytes", image.width, image.height, image.rgba.size()),
            "pass width * height * 4 bytes"};
    }
    std::string png;
    const auto append = [](void* out, void* data, int size) {
        static_cast<std::string*>(out)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
    };
    if (stbi_write_png_to_func(append, &png, image.width, image.height, 4, image.rgba.data(),
                               image.width * 4) == 0) {
        return Error{"image", "could not be compressed", "free some memory"};
    }
    return png;
}

}  // namespace plumb
