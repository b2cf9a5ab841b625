#include "scene/tile_bodies.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "assets/asset_store.hpp"
#include "scene/physics_units.hpp"

namespace plumb {

namespace {

static_assert(static_cast<int>(box_physics::TileShape::HalfBottom) == static_cast<int>(TileShape::HalfBottom),
              "the tile shapes of assets and of physics have the same numbers");

Vec2 flipped(Vec2 point, TileCell flips) {
    if ((flips & kTileFlipDiagonal) != 0) std::swap(point.x, point.y);
    if ((flips & kTileFlipX) != 0) point.x = 1.0f - point.x;
    if ((flips & kTileFlipY) != 0) point.y = 1.0f - point.y;
    return point;
}

/// Turns cells into shape numbers of one field, and remembers the ones that need an outline of their own.
class ShapeFinder {
public:
    ShapeFinder(const Tileset* tileset, box_physics::TileField& field) : tileset_{tileset}, field_{field} {}

    box_physics::TileShape of(TileCell cell) {
        if (cell == 0) return box_physics::TileShape::Empty;
        if (tileset_ == nullptr) return box_physics::TileShape::Full;
        const Tile* tile = tileset_->find(tileOf(cell));
        if (tile == nullptr || tile->shape == TileShape::None) return box_physics::TileShape::Empty;
        const bool plain = (cell & kTileFlips) == 0 || tile->shape == TileShape::Full;
        if (tile->shape == TileShape::OneWay) return box_physics::TileShape::OneWay;
        if (plain && tile->oneWay && tile->shape == TileShape::Full) return box_physics::TileShape::OneWay;
        if (plain && !tile->oneWay && tile->shape != TileShape::Polygon) {
            return static_cast<box_physics::TileShape>(tile->shape);
        }
        return outlined(*tile, cell);
    }

private:
    box_physics::TileShape outlined(const Tile& tile, TileCell cell) {
        for (const auto& [known, shape] : known_) {
            if (known == cell) return shape;
        }
        const Vec2 size{static_cast<float>(tileset_->tileWidth), static_cast<float>(tileset_->tileHeight)};
        std::vector<Vec2> points = outlineOf(tile, size);
        for (Vec2& point : points) point = flipped({point.x / size.x, point.y / size.y}, cell & kTileFlips);
        const auto added = field_.addPolygon(points.data(), static_cast<int>(points.size()), tile.oneWay);
        const auto shape = added.ok() ? *added : box_physics::TileShape::Full;
        known_.emplace_back(cell, shape);
        return shape;
    }

    const Tileset* tileset_;
    box_physics::TileField& field_;
    std::vector<std::pair<TileCell, box_physics::TileShape>> known_;
};

}  // namespace

Vec2 tileSizeOf(const World& world, const TileLayer& layer) {
    if (layer.tileSize.x > 0.0f && layer.tileSize.y > 0.0f) return layer.tileSize;
    const auto* assets = world.service<AssetStore>();
    if (assets == nullptr) return {16.0f, 16.0f};
    const Tileset& tileset = assets->tileset(layer.tileset);
    return {static_cast<float>(std::max(tileset.tileWidth, 1)),
            static_cast<float>(std::max(tileset.tileHeight, 1))};
}

box_physics::TileField tileFieldOf(const World& world, const TileLayer& layer) {
    const TileGrid* grid = world.tiles().find(layer.cells);
    if (grid == nullptr) return {};
    const auto* assets = world.service<AssetStore>();
    box_physics::TileField field{grid->width(), grid->height(), toMetres(tileSizeOf(world, layer))};
    ShapeFinder shapes{assets != nullptr ? &assets->tileset(layer.tileset) : nullptr, field};
    for (int y = 0; y < grid->height(); ++y) {
        for (int x = 0; x < grid->width(); ++x) field.set(x, y, shapes.of(grid->at(x, y)));
    }
    field.finish();
    return field;
}

}  // namespace plumb
