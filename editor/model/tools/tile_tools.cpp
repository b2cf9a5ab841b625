#include "editor/model/tools/tile_tools.hpp"

#include <cmath>
#include <cstdlib>

#include "editor/model/commands/paint_tiles.hpp"
#include "scene/components/tile_layer.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {
namespace {

constexpr Color kCursor{77, 163, 255, 255};
constexpr Color kCursorFill{77, 163, 255, 50};
constexpr float kTileSize = 16.0f;  // px, when only the tileset knows it

struct LayerPlace {
    Vec2 origin;
    Vec2 tile{kTileSize, kTileSize};
};

LayerPlace placeOf(const Document& document, ObjectId layer) {
    LayerPlace place;
    const EntityId entity = document.find(layer);
    if (const Transform* transform = document.world.find<Transform>(entity))
        place.origin = transform->position;
    const TileLayer* tiles = document.world.find<TileLayer>(entity);
    if (tiles != nullptr && tiles->tileSize.x > 0.0f && tiles->tileSize.y > 0.0f)
        place.tile = tiles->tileSize;
    return place;
}

const TileGrid* gridOf(const Document& document, ObjectId layer) {
    const TileLayer* tiles = document.world.find<TileLayer>(document.find(layer));
    return tiles == nullptr ? nullptr : document.world.tiles().find(tiles->cells);
}

}  // namespace

ObjectId activeTileLayer(const Document& document) {
    ObjectId only;
    int count = 0;
    for (const ObjectId id : document.objects()) {
        if (!document.world.has<TileLayer>(document.find(id))) continue;
        if (document.selection.has(id)) return id;
        only = id;
        ++count;
    }
    return count == 1 ? only : ObjectId{};
}

CellPlace cellAt(const Document& document, ObjectId layer, Vec2 point) {
    const LayerPlace place = placeOf(document, layer);
    const Vec2 at = point - place.origin;
    return {static_cast<int>(std::floor(std::fmin(std::fmax(at.x / place.tile.x, -1e6f), 1e6f))),
            static_cast<int>(std::floor(std::fmin(std::fmax(at.y / place.tile.y, -1e6f), 1e6f)))};
}

AABB boxOfCell(const Document& document, ObjectId layer, CellPlace cell) {
    const LayerPlace place = placeOf(document, layer);
    const Vec2 from =
        place.origin + scaled({static_cast<float>(cell.x), static_cast<float>(cell.y)}, place.tile);
    return {from, from + place.tile};
}

void TileTool::press(const ToolContext& context, const Pointer& pointer) {
    const ObjectId layer = activeTileLayer(context.document);
    const TileGrid* grid = gridOf(context.document, layer);
    if (grid == nullptr) return;
    const CellPlace at = cellAt(context.document, layer, pointer.position);
    if (pointer.modifiers.alt) {
        brush.cell = grid->at(at.x, at.y);
        return;
    }
    painting_ = true;
    last_ = pointer.position;
    if (mode_ != Mode::Fill) {
        paintLine(context, last_, last_);
        return;
    }
    std::vector<PaintTiles::Cell> cells = floodFill(*grid, at.x, at.y, brush.cell);
    if (!cells.empty()) context.undo.push(std::make_unique<PaintTiles>(layer, std::move(cells)));
}

void TileTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (!painting_ || mode_ == Mode::Fill) return;
    paintLine(context, last_, pointer.position);
    last_ = pointer.position;
}

void TileTool::release(const ToolContext& context, const Pointer&) {
    painting_ = false;
    context.undo.endGesture();
}

bool TileTool::cancel(const ToolContext& context) {
    if (!painting_) return false;
    painting_ = false;
    if (context.undo.inGesture()) context.undo.cancelGesture();
    return true;
}

void TileTool::paintLine(const ToolContext& context, Vec2 from, Vec2 to) {
    const ObjectId layer = activeTileLayer(context.document);
    const TileGrid* grid = gridOf(context.document, layer);
    if (grid == nullptr) return;
    const TileCell cell = mode_ == Mode::Erase ? 0 : brush.cell;
    const CellPlace a = cellAt(context.document, layer, from);
    const CellPlace b = cellAt(context.document, layer, to);
    const int steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
    std::vector<PaintTiles::Cell> cells;
    for (int i = 0; i <= steps; ++i) {
        // Fast strokes leave no holes: every cell on the way.
        const int x = steps == 0 ? a.x : a.x + (b.x - a.x) * i / steps;
        const int y = steps == 0 ? a.y : a.y + (b.y - a.y) * i / steps;
        if (grid->has(x, y) && grid->at(x, y) != cell) cells.push_back({x, y, cell});
    }
    if (!cells.empty()) context.undo.push(std::make_unique<PaintTiles>(layer, std::move(cells)));
}

void TileTool::draw(const Document& document, const Pointer& pointer, Overlay& overlay) const {
    const ObjectId layer = activeTileLayer(document);
    const TileGrid* grid = gridOf(document, layer);
    if (grid == nullptr) return;
    const CellPlace at = cellAt(document, layer, pointer.position);
    if (!grid->has(at.x, at.y)) return;
    const AABB box = boxOfCell(document, layer, at);
    overlay.filledBox(box, kCursorFill);
    overlay.box(box, kCursor, 1.5f);
}

}  // namespace plumb::editor
