#include "import/map_lattice.hpp"

#include <algorithm>
#include <optional>

namespace plumb {

using tiled::Orientation;

MapLattice::MapLattice(const tiled::Map& map)
    : orientation_{map.orientation},
      staggersX_{map.staggersX},
      staggersEven_{map.staggersEven},
      mapHeight_{map.height},
      tileWidth_{map.tileWidth},
      tileHeight_{map.tileHeight} {
    if (orientation_ == Orientation::Orthogonal) {
        cellWidth_ = tileWidth_;
        cellHeight_ = tileHeight_;
        return;
    }
    int sideX = 0;
    int sideY = 0;
    if (orientation_ != Orientation::Isometric) {
        // Tiled ignores the last pixel of odd sizes of such maps.
        tileWidth_ &= ~1;
        tileHeight_ &= ~1;
    }
    if (orientation_ == Orientation::Hexagonal) (staggersX_ ? sideX : sideY) = map.hexSide;
    cellWidth_ = std::max((tileWidth_ - sideX) / 2 + sideX, 1);
    cellHeight_ = std::max((tileHeight_ - sideY) / 2 + sideY, 1);
}

MapLattice::Cell MapLattice::cellOf(int x, int y) const {
    switch (orientation_) {
        case Orientation::Orthogonal: return {x, y};
        case Orientation::Isometric: return {x - y + mapHeight_ - 1, x + y};
        case Orientation::Staggered:
        case Orientation::Hexagonal: break;
    }
    if (staggersX_) return {x, 2 * y + (isShifted(x) ? 1 : 0)};
    return {2 * x + (isShifted(y) ? 1 : 0), y};
}

MapLattice::Area MapLattice::areaOf(int x, int y, int width, int height) const {
    switch (orientation_) {
        case Orientation::Orthogonal: return {{x, y}, width, height};
        case Orientation::Isometric: {
            const Cell lowerLeft = cellOf(x, y + height - 1);
            const int side = width + height - 1;
            return {{lowerLeft.column, x + y}, side, side};
        }
        case Orientation::Staggered:
        case Orientation::Hexagonal: break;
    }
    return staggersX_ ? Area{{x, 2 * y}, width, 2 * height} : Area{{2 * x, y}, 2 * width, height};
}

Rect MapLattice::boxOf(int x, int y, int width, int height) const {
    const Area area = areaOf(x, y, width, height);
    const auto pixels = [](int cells, int size) {
        return static_cast<float>(cells) * static_cast<float>(size);
    };
    Rect box{pixels(area.first.column, cellWidth_), pixels(area.first.row, cellHeight_),
             pixels(area.width, cellWidth_), pixels(area.height, cellHeight_)};
    if (orientation_ == Orientation::Orthogonal) return box;
    // A tile is wider and higher than its cell. Without a second column or row none is shifted.
    if (orientation_ == Orientation::Isometric || staggersX_ || height > 1)
        box.width += static_cast<float>(tileWidth_ - cellWidth_);
    if (orientation_ == Orientation::Isometric || !staggersX_ || width > 1)
        box.height += static_cast<float>(tileHeight_ - cellHeight_);
    return box;
}

Rect boundsOf(const tiled::Map& map) {
    const MapLattice lattice{map};
    if (!map.infinite) return lattice.boxOf(0, 0, map.width, map.height);
    std::optional<AABB> all;
    for (const tiled::Layer& layer : map.layers) {
        if (layer.cells.empty()) continue;
        const Rect box = lattice.boxOf(layer.x, layer.y, layer.width, layer.height);
        const AABB own{{box.x, box.y}, {box.x + box.width, box.y + box.height}};
        all = all ? merged(*all, own) : own;
    }
    if (!all) return {};
    return {all->min.x, all->min.y, all->size().x, all->size().y};
}

}  // namespace plumb
