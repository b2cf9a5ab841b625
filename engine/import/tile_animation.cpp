#include "import/tile_animation.hpp"

#include <algorithm>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "platform/image_file.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr std::size_t kMaxStripBytes = std::size_t{64} << 20;  // pixels of a strip of frames

/// Copies a region of an image to column `left` of another, clipped to both images.
void copyPixels(const Image& from, const Rect& part, Image& to, int left) {
    const int width = static_cast<int>(part.width);
    const int startX = static_cast<int>(part.x);
    const int startY = static_cast<int>(part.y);
    const int rows = std::min({static_cast<int>(part.height), from.height - startY, to.height});
    const int columns = std::min({width, from.width - startX, to.width - left});
    if (columns <= 0 || startX < 0 || startY < 0) return;
    for (int y = 0; y < rows; ++y) {
        const auto source = (static_cast<std::ptrdiff_t>(startY + y) * from.width + startX) * 4;
        const auto target = (static_cast<std::ptrdiff_t>(y) * to.width + left) * 4;
        std::copy_n(from.rgba.begin() + source, columns * 4, to.rgba.begin() + target);
    }
}

Json framesJson(const tiled::Tile& tile) {
    Json frames = Json::array();
    for (std::size_t i = 0; i < tile.animation.size(); ++i) {
        Json frame = Json::object();
        frame["cell"] = Json::array({static_cast<int>(i), 0});
        frame["seconds"] = static_cast<float>(std::max(tile.animation[i].milliseconds, 1)) / 1000.0f;
        frames.push_back(std::move(frame));
    }
    return frames;
}

/// Returns an image with the frames side by side; empty if a frame has no image or the result is too large.
Image stripOf(const ImportedTileset& tileset, const tiled::Tile& tile, Rect cell, ImportStage& stage) {
    const Image& first = stage.pixels(tileset.pictureOf(tile.animation.front().tile).texture);
    const int width = std::min(static_cast<int>(cell.width), first.width);
    const int height = std::min(static_cast<int>(cell.height), first.height);
    if (width <= 0 || height <= 0) return {};
    if (tile.animation.size() > static_cast<std::size_t>(limits::kImageSide / width)) return {};
    Image strip;
    strip.width = width * static_cast<int>(tile.animation.size());
    strip.height = height;
    const std::size_t bytes =
        static_cast<std::size_t>(strip.width) * static_cast<std::size_t>(strip.height) * 4;
    if (bytes > kMaxStripBytes) return {};
    strip.rgba.resize(bytes);
    int left = 0;
    for (const tiled::Frame& frame : tile.animation) {
        TileRegion picture = tileset.pictureOf(frame.tile);
        picture.source.width = std::min(picture.source.width, static_cast<float>(width));
        copyPixels(stage.pixels(picture.texture), picture.source, strip, left);
        left += width;
    }
    return strip;
}

}  // namespace

int shownTile(const tiled::Tileset& tileset, int id) {
    const tiled::Tile* tile = tileset.find(id);
    return tile && !tile->animation.empty() ? tile->animation.front().tile : id;
}

const TileAnimations::StagedAnimation* TileAnimations::of(const ImportedTileset& tileset, int id,
                                                          ImportStage& stage) {
    const tiled::Tile* tile = tileset.original->find(id);
    if (!tile || tile->animation.empty()) return nullptr;
    const auto [at, isNew] = made_.try_emplace({tileset.original, id});
    StagedAnimation& made = at->second;
    if (!isNew) return &made;

    const Rect cell = tileset.pictureOf(tile->animation.front().tile).source;
    const std::string name = format("{}-{}", tileset.original->name, id);
    const Image strip = stripOf(tileset, *tile, cell, stage);
    const Result<std::string> png = encodePng(strip);
    if (!png) {
        stage.problems.push_back(
            {name, "the frames of the animation do not fit in one image", "check the frames and images"});
        return &made;
    }
    made.texture = stage.add(name, ".png", *png);
    Json clip = Json::object();
    clip["name"] = "frames";
    clip["loop"] = "loop";
    clip["frames"] = framesJson(*tile);
    Json json = Json::object();
    json["format"] = 1;
    json["image"] = made.texture;
    json["frameSize"] = Json::array({strip.width / static_cast<int>(tile->animation.size()), strip.height});
    json["clips"] = Json::array();
    json["clips"].push_back(std::move(clip));
    made.file = stage.add(name, ".anim.json", writeJson(json));
    return &made;
}

}  // namespace plumb
