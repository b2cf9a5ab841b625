#include "editor/ui/overlays/tile_collision.hpp"

#include <algorithm>
#include <utility>

#include "editor/model/document/tile_layers.hpp"
#include "render/view.hpp"
#include "scene/components/colliders/tile_collider.hpp"

namespace plumb::editor::ui {
namespace {

constexpr Color kSolid{110, 230, 140, 220};
constexpr Color kOneWay{120, 200, 255, 230};
constexpr int kMostCells = 20000;  // maximum number of visible cells; more would cover the scene

/// Applies the flips of a cell to a point of a tile, in units of the tile size.
Vec2 flipped(Vec2 point, TileCell cell) {
    if ((cell & kTileFlipDiagonal) != 0) std::swap(point.x, point.y);
    if ((cell & kTileFlipX) != 0) point.x = 1.0f - point.x;
    if ((cell & kTileFlipY) != 0) point.y = 1.0f - point.y;
    return point;
}

void drawCell(const Tileset& tileset, TileCell cell, const AABB& box, Overlay& overlay) {
    const Tile* tile = tileset.find(tileOf(cell));
    if (tile == nullptr || tile->shape == TileShape::None) return;
    const Vec2 size{static_cast<float>(tileset.tileWidth), static_cast<float>(tileset.tileHeight)};
    const bool oneWay = tile->oneWay || tile->shape == TileShape::OneWay;
    const Color color = oneWay ? kOneWay : kSolid;
    const auto placed = [&](Vec2 point) {
        return box.min + scaled(flipped({point.x / size.x, point.y / size.y}, cell), box.size());
    };
    for (const std::vector<Vec2>& outline : outlinesOf(*tile, size)) {
        for (std::size_t i = 0; i < outline.size(); ++i)
            overlay.line(placed(outline[i]), placed(outline[(i + 1) % outline.size()]), color);
    }
    if (!oneWay) return;
    const Vec2 middle = box.center();
    overlay.arrow({middle.x, box.max.y - box.size().y * 0.25f}, {middle.x, box.min.y}, color);
}

void drawLayer(const Workspace& workspace, ObjectId layer, Overlay& overlay) {
    const Document& document = workspace.document;
    const TileGrid* grid = gridOf(document, layer);
    const Tileset* tileset = tilesetOf(document, layer);
    if (grid == nullptr || tileset == nullptr) return;
    const AABB seen = visibleBox(workspace.view.view());
    const CellPlace from = cellAt(document, layer, seen.min);
    const CellPlace to = cellAt(document, layer, seen.max);
    const int left = std::max(from.x, 0);
    const int right = std::min(to.x, grid->width() - 1);
    const int top = std::max(from.y, 0);
    const int bottom = std::min(to.y, grid->height() - 1);
    if (left > right || top > bottom || (right - left + 1) > kMostCells / (bottom - top + 1)) return;
    const AABB first = boxOfCell(document, layer, {0, 0});
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            const TileCell cell = grid->at(x, y);
            if (cell == 0) continue;
            const Vec2 corner =
                first.min + scaled({static_cast<float>(x), static_cast<float>(y)}, first.size());
            drawCell(*tileset, cell, {corner, corner + first.size()}, overlay);
        }
    }
}

}  // namespace

void drawTileCollision(const Workspace& workspace, const World&, Overlay& overlay) {
    if (workspace.play.running()) return;  // a running game shows collision shapes with F3
    const Document& document = workspace.document;
    for (const ObjectId layer : tileLayers(document)) {
        const bool solid = document.world.has<TileCollider>(document.find(layer));
        if (solid && !workspace.document.view.hides(layer)) drawLayer(workspace, layer, overlay);
    }
}

}  // namespace plumb::editor::ui
