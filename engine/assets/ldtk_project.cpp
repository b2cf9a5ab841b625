#include "assets/ldtk_project.hpp"

#include <algorithm>

namespace plumb::ldtk {
namespace {

int tilesAlong(int pixels, const Tileset& tileset) {
    const int step = std::max(tileset.grid + tileset.spacing, 1);
    return std::max((pixels - 2 * tileset.padding + tileset.spacing) / step, 1);
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
    const int step = grid + spacing;
    return {static_cast<float>(padding + tile % columns() * step),
            static_cast<float>(padding + tile / columns() * step), static_cast<float>(grid),
            static_cast<float>(grid)};
}

const Tileset* Project::tileset(int uid) const { return withUid(tilesets, uid); }
const LayerKind* Project::layerKind(int uid) const { return withUid(layers, uid); }
const EntityKind* Project::entityKind(int uid) const { return withUid(entities, uid); }

}  // namespace plumb::ldtk
