#include "import/ldtk_project.hpp"

#include <algorithm>

namespace plumb::ldtk {
namespace {

int stepOf(const Tileset& tileset) { return std::max(tileset.grid + tileset.spacing, 1); }

/// Returns the number of tiles along an image side. Like LDtk, counts a tile that the image's edge cuts off.
int tilesAlong(int pixels, const Tileset& tileset) {
    const int step = stepOf(tileset);
    return std::max((pixels - 2 * tileset.padding + step - 1) / step, 1);
}

template <class T>
const T* withUid(const std::vector<T>& items, int uid) {
    for (const T& item : items) {
        if (item.uid == uid) return &item;
    }
    return nullptr;
}

}  // namespace

int Tileset::columns() const { return tilesAlong(imageWidth, *this); }
int Tileset::rows() const { return tilesAlong(imageHeight, *this); }

Rect Tileset::sourceOf(int tile) const {
    const std::int64_t step = stepOf(*this);  // 64 bit: `tile` can be any value from the file
    return {static_cast<float>(padding + tile % columns() * step),
            static_cast<float>(padding + tile / columns() * step), static_cast<float>(grid),
            static_cast<float>(grid)};
}

int Tileset::tileAt(int x, int y) const {
    const int step = stepOf(*this);
    const int column = (x - padding) / step;
    const int row = (y - padding) / step;
    const bool onGrid =
        x >= padding && y >= padding && (x - padding) % step == 0 && (y - padding) % step == 0;
    return onGrid && column < columns() && row < rows() ? row * columns() + column : -1;
}

const Tileset* Project::tileset(int uid) const { return withUid(tilesets, uid); }
const LayerKind* Project::layerKind(int uid) const { return withUid(layers, uid); }
const EntityKind* Project::entityKind(int uid) const { return withUid(entities, uid); }

}  // namespace plumb::ldtk
