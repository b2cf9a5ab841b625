#include "editor/model/tools/move_tiles_tool.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "editor/model/tiles/cell_shapes.hpp"
#include "editor/model/tiles/tile_brush.hpp"
#include "editor/model/tools/tile_marks.hpp"
#include "scene/components/drawing/tile_layer.hpp"

namespace plumb::editor {
namespace {

constexpr std::size_t kMostGhosts = 4096;  // maximum number of tiles drawn in the preview

/// The new values of changed cells of a grid.
class NextCells {
public:
    explicit NextCells(const TileGrid& grid) : grid_{grid} {}
    void set(int x, int y, TileCell cell) {
        if (grid_.has(x, y)) cells_[{y, x}] = cell;
    }
    [[nodiscard]] std::vector<PaintTiles::Cell> changed() const {
        std::vector<PaintTiles::Cell> changed;
        for (const auto& [place, cell] : cells_) {
            if (grid_.at(place.second, place.first) != cell)
                changed.push_back({place.second, place.first, cell});
        }
        return changed;
    }

private:
    const TileGrid& grid_;
    std::map<std::pair<int, int>, TileCell> cells_;
};

/// Computes the cells that change when the selected ones are moved or copied. Empty cells do not overwrite
/// others.
std::vector<PaintTiles::Cell> moved(const TileGrid& grid, const CellSelection& selected, int dx, int dy,
                                    bool copies) {
    NextCells next{grid};
    for (const CellPlace place : selected.all()) {
        if (!copies) next.set(place.x, place.y, 0);
    }
    for (const CellPlace place : selected.all()) {
        if (const TileCell cell = grid.at(place.x, place.y); cell != 0)
            next.set(place.x + dx, place.y + dy, cell);
    }
    return next.changed();
}

ObjectId freeLayer(const ToolContext& context) {
    const ObjectId layer = activeTileLayer(context.document, context.tiles);
    const bool free = gridOf(context.document, layer) != nullptr && !context.document.view.locks(layer) &&
                      !context.document.view.hides(layer);
    return free ? layer : ObjectId{};
}

}  // namespace

bool moveSelectedTiles(const ToolContext& context, int dx, int dy, bool copies) {
    const ObjectId layer = freeLayer(context);
    if (!layer || context.tiles.selected.empty() || (dx == 0 && dy == 0)) return false;
    PaintTiles::Change change;
    change.cells = moved(*gridOf(context.document, layer), context.tiles.selected, dx, dy, copies);
    // Terrain moves with its tiles, so that later terrain strokes beside them connect to it.
    if (const TileGrid* terrain = terrainOf(context.document, layer))
        change.terrain = moved(*terrain, context.tiles.selected, dx, dy, copies);
    context.tiles.selected.move(dx, dy);
    if (change.empty()) return false;
    context.undo.push(
        std::make_unique<PaintTiles>(layer, std::move(change), copies ? "copy tiles" : "move tiles"));
    return true;
}

void clearSelectedTiles(const ToolContext& context) {
    const ObjectId layer = freeLayer(context);
    if (!layer) return;
    const TileBrush eraser{context.document, context.tiles, layer, TileInk::Nothing, 0};
    std::vector<CellPlace> inside = context.tiles.selected.all();
    std::erase_if(inside, [&](CellPlace place) { return !eraser.grid().has(place.x, place.y); });
    PaintTiles::Change change = eraser.change(inside, {});
    if (change.empty()) return;
    context.undo.push(std::make_unique<PaintTiles>(layer, std::move(change), "clear tiles"));
    context.undo.endGesture();
}

TileStamp selectedTiles(const ToolContext& context) {
    const TileGrid* grid = gridOf(context.document, activeTileLayer(context.document, context.tiles));
    const std::vector<CellPlace>& cells = context.tiles.selected.all();
    if (grid == nullptr || cells.empty()) return {};
    CellPlace from = cells.front();
    CellPlace to = cells.front();
    for (const CellPlace place : cells) {
        from = {std::min(from.x, place.x), std::min(from.y, place.y)};
        to = {std::max(to.x, place.x), std::max(to.y, place.y)};
    }
    TileStamp stamp{to.x - from.x + 1, to.y - from.y + 1, {}};
    stamp.cells.assign(static_cast<std::size_t>(stamp.width) * static_cast<std::size_t>(stamp.height), 0);
    for (const CellPlace place : cells) {
        stamp.cells[static_cast<std::size_t>(place.y - from.y) * static_cast<std::size_t>(stamp.width) +
                    static_cast<std::size_t>(place.x - from.x)] = grid->at(place.x, place.y);
    }
    return stamp;
}

void MoveTilesTool::press(const ToolContext& context, const Pointer& pointer) {
    const ObjectId layer = activeTileLayer(context.document, context.tiles);
    if (gridOf(context.document, layer) == nullptr) return;
    context.tiles.layer = layer;
    start_ = last_ = cellAt(context.document, layer, pointer.position);
    const bool changesSelection = pointer.modifiers.shift || pointer.modifiers.control;
    doing_ = context.tiles.selected.has(start_) && !changesSelection && freeLayer(context) ? Doing::Moving
                                                                                           : Doing::Boxing;
}

void MoveTilesTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (doing_ != Doing::Nothing) last_ = cellAt(context.document, context.tiles.layer, pointer.position);
}

void MoveTilesTool::release(const ToolContext& context, const Pointer& pointer) {
    if (doing_ == Doing::Boxing) selectBox(context, pointer);
    if (doing_ == Doing::Moving)
        moveSelectedTiles(context, last_.x - start_.x, last_.y - start_.y, pointer.modifiers.alt);
    doing_ = Doing::Nothing;
    context.undo.endGesture();
}

bool MoveTilesTool::cancel(const ToolContext&) {
    return std::exchange(doing_, Doing::Nothing) != Doing::Nothing;
}

void MoveTilesTool::selectBox(const ToolContext& context, const Pointer& pointer) const {
    const TileGrid& grid = *gridOf(context.document, context.tiles.layer);
    std::vector<CellPlace> cells = boxOfCells(grid, start_, last_);
    // Without Shift or Ctrl, the box replaces the selection; outside of the grid it clears it.
    if (pointer.modifiers.control) return context.tiles.selected.remove(std::move(cells));
    if (!pointer.modifiers.shift) context.tiles.selected.clear();
    context.tiles.selected.add(cells);
}

void MoveTilesTool::draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    const Document& document = context.document;
    const ObjectId layer = activeTileLayer(document, context.tiles);
    const TileGrid* grid = gridOf(document, layer);
    if (grid == nullptr) return;
    if (doing_ == Doing::Moving) {
        const int dx = last_.x - start_.x;
        const int dy = last_.y - start_.y;
        const TileLayer& tiles = document.world.get<TileLayer>(document.find(layer));
        const std::vector<CellPlace>& cells = context.tiles.selected.all();
        for (std::size_t i = 0; i < cells.size() && i < kMostGhosts; ++i) {
            const AABB box = boxOfCell(document, layer, {cells[i].x + dx, cells[i].y + dy});
            if (!pointer.modifiers.alt)
                overlay.filledBox(boxOfCell(document, layer, cells[i]), marks::kEraseFill);
            const TileCell cell = grid->at(cells[i].x, cells[i].y);
            if (cell != 0) overlay.tile(box, tiles.tileset, cell, marks::kGhost);
            overlay.filledBox(box, marks::kSelectedFill);
        }
        return;
    }
    marks::drawLayer(context, layer, overlay);
    const CellPlace at = cellAt(document, layer, pointer.position);
    const bool boxing = doing_ == Doing::Boxing;
    const AABB box = boxOfCells(document, layer, boxing ? start_ : at, boxing ? last_ : at);
    if (boxing) overlay.filledBox(box, marks::kSelectedFill);
    overlay.box(box, marks::kSelected, 1.5f);
    if (boxing) marks::drawSize(box, start_, last_, overlay);
}

}  // namespace plumb::editor
