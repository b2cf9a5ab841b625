#include "render/tileset_looks.hpp"

namespace plumb {
namespace {

TileLook lookOf(const Tileset& tileset, int tile, TextureLibrary& textures) {
    const TileImage* own = tileset.imageOf(tile);
    const TextureRegion& region = textures.regionOf(own != nullptr ? own->texture : tileset.texture);
    if (own == nullptr) return {region.texture, region.part(tileset.sourceOf(tile))};
    return {region.texture, own->source.empty() ? region.whole() : region.part(own->source)};
}

}  // namespace

TileSheet TilesetLooks::sheet(const AssetStore& assets, TextureLibrary& textures, TilesetId id, Vec2 tileSize,
                              double seconds) {
    const Tileset& tileset = assets.tileset(id);
    const std::uint32_t revision = assets.revisionOf(AssetKind::Tileset, id.path);
    if (version_ == 0 || id != id_ || revision != revision_ || textures.version() != textureVersion_) {
        rebuild(tileset, textures);
        id_ = id;
        revision_ = revision;
        textureVersion_ = textures.version();
        ++version_;
    }
    animate(tileset, textures, seconds);

    TileSheet sheet;
    sheet.looks = looks_;
    sheet.version = version_;
    const Vec2 own{static_cast<float>(tileset.tileWidth), static_cast<float>(tileset.tileHeight)};
    sheet.cellSize = tileSize.x > 0.0f && tileSize.y > 0.0f ? tileSize : own;
    sheet.scale = {sheet.cellSize.x / own.x, sheet.cellSize.y / own.y};
    sheet.offset = scaled(tileset.offset, sheet.scale);
    return sheet;
}

void TilesetLooks::rebuild(const Tileset& tileset, TextureLibrary& textures) {
    looks_.clear();
    looks_.reserve(static_cast<std::size_t>(tileset.count));
    for (int tile = 0; tile < tileset.count; ++tile) looks_.push_back(lookOf(tileset, tile, textures));
}

void TilesetLooks::animate(const Tileset& tileset, TextureLibrary& textures, double seconds) {
    for (const Tile& tile : tileset.tiles) {
        const auto index = static_cast<std::size_t>(tile.id);
        if (tile.animation.empty() || tile.id < 0 || index >= looks_.size()) continue;
        looks_[index] = lookOf(tileset, tileset.shownTile(tile.id, seconds), textures);
        looks_[index].animated = true;
    }
}

}  // namespace plumb
