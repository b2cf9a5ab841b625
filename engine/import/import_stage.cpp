#include "import/import_stage.hpp"

#include <utility>

#include "core/text.hpp"
#include "platform/image_file.hpp"

namespace plumb {
namespace {

constexpr std::size_t kMaxName = 64;

std::string lowerCase(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

/// Returns the file extension that fits the content, regardless of the original file's name.
std::string_view endingOf(std::string_view bytes) {
    if (startsWith(bytes, "\x89PNG")) return ".png";
    if (startsWith(bytes, "\xff\xd8")) return ".jpg";
    if (startsWith(bytes, "BM")) return ".bmp";
    return ".gif";
}

void makeTransparent(Image& image, Color keyed) {
    for (std::size_t at = 0; at + 4 <= image.rgba.size(); at += 4) {
        const bool same =
            image.rgba[at] == keyed.r && image.rgba[at + 1] == keyed.g && image.rgba[at + 2] == keyed.b;
        if (same) image.rgba[at + 3] = 0;
    }
}

Result<std::string> keyedPng(std::string_view bytes, Color keyed, std::string_view where) {
    Result<Image> image = decodeImage(bytes, where);
    if (!image) return image.error();
    makeTransparent(*image, keyed);
    return encodePng(*image);
}

}  // namespace

std::string plainName(std::string_view wished) {
    std::string name;
    for (const char c : wished.substr(0, kMaxName)) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        name += plain ? c : '_';
    }
    return name.empty() ? "unnamed" : name;
}

std::string ImportStage::uniquePath(std::string_view wished, std::string_view ending) {
    const std::string stem = format("{}/{}", folder_, plainName(wished));
    // On some file systems Tree.png and tree.png are the same file.
    for (int number = 1;; ++number) {
        std::string path = number == 1 ? stem : format("{}-{}", stem, number);
        path += ending;
        if (taken_.insert(lowerCase(path)).second) return path;
    }
}

std::string ImportStage::add(std::string_view wished, std::string_view ending, std::string bytes) {
    files_.push_back({uniquePath(wished, ending), std::move(bytes)});
    return files_.back().path;
}

const StagedImage& ImportStage::image(const Path& from, std::optional<Color> keyed) {
    const Path file = from.lexically_normal();
    std::string key = file.generic_string();
    if (keyed) key += format("#{},{},{}", int{keyed->r}, int{keyed->g}, int{keyed->b});
    const auto [at, isNew] = images_.try_emplace(key);
    StagedImage& staged = at->second;
    if (!isNew) return staged;

    const std::string where = file.generic_string();
    Result<std::string> bytes = readFile(file);
    const Result<ImageSize> size = bytes ? readImageSize(*bytes, where) : Result<ImageSize>{bytes.error()};
    if (size && keyed) bytes = keyedPng(*bytes, *keyed, where);
    if (!size || !bytes) {
        problems.push_back(size ? bytes.error() : size.error());
        staged.path = uniquePath(file.stem().string(), ".png");
        return staged;
    }
    const std::string_view ending = endingOf(*bytes);
    staged = {add(file.stem().string(), ending, std::move(*bytes)), size->width, size->height};
    return staged;
}

Result<Done> ImportStage::addImage(const Path& name, std::string_view wished, const Image& image) {
    Result<std::string> png = encodePng(image);
    if (!png) return png.error();
    images_[name.lexically_normal().generic_string()] = {add(wished, ".png", std::move(*png)), image.width,
                                                         image.height};
    return Done{};
}

const Image& ImportStage::pixels(std::string_view path) {
    if (path == decodedPath_) return decoded_;
    decodedPath_ = path;
    decoded_ = {};
    for (const ImportedFile& file : files_) {
        if (file.path != path) continue;
        Result<Image> image = decodeImage(file.bytes, file.path);
        if (image) decoded_ = std::move(*image);
    }
    return decoded_;
}

}  // namespace plumb
