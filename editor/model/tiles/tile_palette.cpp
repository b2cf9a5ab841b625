#include "editor/model/tiles/tile_palette.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::editor {
namespace {

constexpr int kCollectionColumns = 8;

}  // namespace

TilePalette paletteOf(const Tileset& tileset) {
    TilePalette palette;
    const bool collection = tileset.image.empty() && !tileset.images.empty();
    palette.count = tileset.count;
    if (collection) palette.count = std::max(palette.count, tileset.images.back().tile + 1);
    palette.columns =
        std::max(collection ? std::min(kCollectionColumns, palette.count) : tileset.currentColumns(), 1);
    palette.rows = (palette.count + palette.columns - 1) / palette.columns;
    if (!collection && !tileset.sizes.empty()) palette.grown = &tileset;
    palette.tileSize = {static_cast<float>(std::max(tileset.tileWidth, 1)),
                        static_cast<float>(std::max(tileset.tileHeight, 1))};
    return palette;
}

int TilePalette::tileAt(CellPlace place) const {
    if (grown != nullptr) return grown->tileAt({place.x, place.y});
    if (place.x < 0 || place.y < 0 || place.x >= columns) return -1;
    const int tile = place.y * columns + place.x;
    return tile < count ? tile : -1;
}

CellPlace TilePalette::placeOf(int tile) const {
    if (grown == nullptr) return {tile % columns, tile / columns};
    const Tileset::Place place = grown->placeOf(tile);
    return {place.column, place.row};
}

CellPlace TilePalette::nearest(Vec2 point) const {
    const auto clamped = [](float value, int last) {
        return static_cast<int>(std::clamp(std::floor(value), 0.0f, static_cast<float>(std::max(last, 0))));
    };
    return {clamped(point.x / tileSize.x, columns - 1), clamped(point.y / tileSize.y, rows - 1)};
}

Vec2 TilePalette::size() const {
    return {tileSize.x * static_cast<float>(columns), tileSize.y * static_cast<float>(rows)};
}

TileStamp TilePalette::stamp(CellPlace a, CellPlace b) const {
    const CellPlace from{std::min(a.x, b.x), std::min(a.y, b.y)};
    TileStamp made{std::abs(a.x - b.x) + 1, std::abs(a.y - b.y) + 1, {}};
    for (int y = 0; y < made.height; ++y) {
        for (int x = 0; x < made.width; ++x) {
            made.cells.push_back(cellOf(tileAt({from.x + x, from.y + y})));
        }
    }
    return made;
}

}  // namespace plumb::editor
