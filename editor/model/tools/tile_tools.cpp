#include "editor/model/tools/tile_tools.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/tiles/cell_shapes.hpp"
#include "editor/model/tools/tile_marks.hpp"
#include "scene/components/drawing/tile_layer.hpp"

namespace plumb::editor {
namespace {

constexpr std::size_t kMostGhosts = 4096;  // maximum number of previewed tiles; more are drawn as a box
constexpr int kFillColumns = 45;           // columns previewed on each side of the pointer
constexpr int kFillRows = 22;              // rows previewed above and below the pointer

bool isShape(TileTool::Mode mode) {
    using Mode = TileTool::Mode;
    return mode == Mode::Line || mode == Mode::Rectangle || mode == Mode::Ellipse;
}

/// Preview of a fill.
struct FillArea {
    std::vector<CellPlace> places;  // cells to fill, only those near the pointer
    std::string words;              // description of the whole area, e.g. "12 cells"
};

/// @param equal  true: fills all cells equal to the one at `at`, not only those connected to it
FillArea fillArea(const TileBrush& brush, const CellSelection& selected, CellPlace at, bool equal) {
    const TileGrid& grid = brush.grid();
    if (selected.has(at)) {
        std::vector<CellPlace> near = boxOfCells(grid, {at.x - kFillColumns, at.y - kFillRows},
                                                 {at.x + kFillColumns, at.y + kFillRows});
        std::erase_if(near, [&](CellPlace place) { return !selected.has(place); });
        return {std::move(near), "the selection"};
    }
    if (equal)
        return {equalCellsNear(grid, brush.equalTerrain(), at, kFillColumns, kFillRows), "all equal cells"};
    std::vector<CellPlace> connected = connectedCells(grid, brush.equalTerrain(), at, kMostGhosts);
    const std::size_t count = connected.size();
    return {std::move(connected), count >= kMostGhosts ? format("more than {} cells", kMostGhosts)
                                  : count == 1         ? std::string{"1 cell"}
                                                       : format("{} cells", count)};
}

}  // namespace

std::string_view TileTool::next() const { return mode_ == Mode::Pick ? "tool.brush" : ""; }

TileBrush TileTool::brush(const ToolContext& context) const {
    TileInk ink = ink_;
    if (doing_ == Doing::Nothing) {
        ink = mode_ == Mode::Erase          ? TileInk::Nothing
              : context.tiles.activeTerrain ? TileInk::Terrain
                                            : TileInk::Stamp;
    }
    return {context.document, context.tiles, activeTileLayer(context.document, context.tiles), ink,
            stroke_,          &derived_};
}

bool TileTool::picks(const ToolContext& context, const Pointer& pointer) const {
    if (mode_ == Mode::Pick || pointer.modifiers.alt) return true;
    return pointer.secondary && !context.tiles.rightErases;
}

CellPlace TileTool::placeAt(const ToolContext& context, const Pointer& pointer) const {
    const ObjectId layer = activeTileLayer(context.document, context.tiles);
    const bool corners = doing_ != Doing::Picking && mode_ != Mode::Same && brush(context).onCorners();
    return corners ? cornerAt(context.document, layer, pointer.position)
                   : cellAt(context.document, layer, pointer.position);
}

void TileTool::press(const ToolContext& context, const Pointer& pointer) {
    const ObjectId layer = activeTileLayer(context.document, context.tiles);
    if (gridOf(context.document, layer) == nullptr) return;
    context.tiles.layer = layer;
    ++stroke_;
    const bool erases = mode_ == Mode::Erase || pointer.secondary;
    ink_ = erases ? TileInk::Nothing : context.tiles.activeTerrain ? TileInk::Terrain : TileInk::Stamp;
    doing_ = Doing::Nothing;
    if (picks(context, pointer)) {
        doing_ = Doing::Picking;
    } else if (context.document.view.locks(layer) || context.document.view.hides(layer)) {
        return;
    } else if (isShape(mode_) || ((mode_ == Mode::Brush || mode_ == Mode::Erase) &&
                                  pointer.modifiers.control && pointer.modifiers.shift)) {
        doing_ = Doing::Shaping;
        shape_ = isShape(mode_) ? mode_ : Mode::Rectangle;
    } else {
        doing_ = Doing::Painting;
    }
    start_ = last_ = placeAt(context, pointer);
    if (doing_ == Doing::Painting) click(context, pointer);
}

void TileTool::click(const ToolContext& context, const Pointer& pointer) const {
    if (mode_ == Mode::Same) return selectSame(context, pointer);
    if (mode_ == Mode::Fill) return fill(context, pointer);
    paintLine(context, pointer.modifiers.shift ? strokeEnd_.value_or(start_) : start_, start_);
}

void TileTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (doing_ == Doing::Nothing) return;
    CellPlace at = placeAt(context, pointer);
    const bool freehand = mode_ == Mode::Brush || mode_ == Mode::Erase;
    if (doing_ == Doing::Painting && freehand && at != last_) paintLine(context, last_, at);
    const bool square = pointer.modifiers.shift && !pointer.modifiers.control;
    if (doing_ == Doing::Shaping && shape_ != Mode::Line && square) at = squareCorner(start_, at);
    last_ = at;
}

void TileTool::release(const ToolContext& context, const Pointer&) {
    if (doing_ == Doing::Shaping) {
        const TileBrush now = brush(context);
        if (now.ready()) paint(context, now, shaped(now));
    }
    if (doing_ == Doing::Picking) pick(context);
    if (doing_ == Doing::Painting) strokeEnd_ = last_;
    doing_ = Doing::Nothing;
    context.undo.endGesture();
}

bool TileTool::cancel(const ToolContext& context) {
    const Doing was = std::exchange(doing_, Doing::Nothing);
    if (was == Doing::Painting && context.undo.inGesture()) context.undo.cancelGesture();
    return was != Doing::Nothing;
}

std::vector<CellPlace> TileTool::shaped(const TileBrush& brush) const {
    if (shape_ == Mode::Line) return lineOfCells(start_, last_);
    if (shape_ == Mode::Ellipse) return ellipseOfCells(brush.grid(), start_, last_);
    return boxOfCells(brush.grid(), start_, last_);
}

void TileTool::paintLine(const ToolContext& context, CellPlace from, CellPlace to) const {
    const TileBrush now = brush(context);
    if (!now.ready()) return;
    std::vector<CellPlace> places;
    for (const CellPlace at : lineOfCells(from, to)) {
        const std::vector<CellPlace> covered = now.coveredAt(at);
        places.insert(places.end(), covered.begin(), covered.end());
    }
    paint(context, now, std::move(places));
}

void TileTool::paint(const ToolContext& context, const TileBrush& brush,
                     std::vector<CellPlace> places) const {
    CellSelection once;
    once.set(std::move(places));
    // The pattern of a box starts at its upper left corner, wherever the drag started.
    const CellPlace origin = doing_ == Doing::Shaping && shape_ != Mode::Line
                                 ? CellPlace{std::min(start_.x, last_.x), std::min(start_.y, last_.y)}
                                 : start_;
    PaintTiles::Change change = brush.change(once.all(), origin);
    if (!change.empty())
        context.undo.push(std::make_unique<PaintTiles>(context.tiles.layer, std::move(change)));
}

/// Fills the connected equal cells; with Shift all equal cells; on a selected cell the whole selection.
void TileTool::fill(const ToolContext& context, const Pointer& pointer) const {
    const TileBrush now = brush(context);
    if (!now.ready()) return;
    const CellPlace at = cellAt(context.document, context.tiles.layer, pointer.position);
    if (context.tiles.selected.has(at)) return paint(context, now, context.tiles.selected.all());
    paint(context, now,
          pointer.modifiers.shift ? equalCells(now.grid(), now.equalTerrain(), at)
                                  : connectedCells(now.grid(), now.equalTerrain(), at));
}

void TileTool::selectSame(const ToolContext& context, const Pointer& pointer) const {
    const TileGrid& grid = *gridOf(context.document, context.tiles.layer);
    std::vector<CellPlace> equal = equalCells(grid, nullptr, start_);
    if (pointer.modifiers.shift) {
        context.tiles.selected.add(equal);
    } else if (pointer.modifiers.control) {
        context.tiles.selected.remove(std::move(equal));
    } else {
        context.tiles.selected.set(std::move(equal));
    }
}

/// Picks the terrain if a single cell with terrain was clicked while painting terrain; otherwise picks a
/// stamp.
void TileTool::pick(const ToolContext& context) const {
    const TileGrid* grid = gridOf(context.document, context.tiles.layer);
    const TileGrid* terrain = terrainOf(context.document, context.tiles.layer);
    if (grid == nullptr) return;
    TilePaint& tiles = context.tiles;
    const int id =
        terrain == nullptr || start_ != last_ ? 0 : static_cast<int>(terrain->at(start_.x, start_.y));
    if (tiles.activeTerrain && id != 0) {
        tiles.terrain = id;
    } else {
        tiles.stamp = stampFrom(*grid, start_, last_);
        tiles.activeTerrain = false;
    }
}

/// Draws a preview of the tiles that would be painted.
void TileTool::drawGhost(const ToolContext& context, const TileBrush& brush,
                         const std::vector<CellPlace>& places, CellPlace origin, Overlay& overlay) const {
    const Document& document = context.document;
    const ObjectId layer = activeTileLayer(document, context.tiles);
    const TileLayer& tiles = document.world.get<TileLayer>(document.find(layer));
    for (const PaintTiles::Cell& cell : brush.change(places, origin).cells) {
        const AABB box = boxOfCell(document, layer, {cell.x, cell.y});
        if (cell.cell == 0) {
            overlay.filledBox(box, marks::kEraseFill);
        } else {
            overlay.tile(box, tiles.tileset, cell.cell, marks::kGhost);
        }
    }
}

/// Draws a preview of the cells that a click would fill, and a text with their number. Of a very large area
/// only the part near the pointer is drawn.
void TileTool::drawFill(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    const ObjectId layer = activeTileLayer(context.document, context.tiles);
    const TileBrush now = brush(context);
    const CellPlace at = cellAt(context.document, layer, pointer.position);
    if (!now.ready() || !now.grid().has(at.x, at.y)) return;
    FillArea area = fillArea(now, context.tiles.selected, at, pointer.modifiers.shift);
    CellSelection once;
    once.set(std::move(area.places));
    drawGhost(context, now, once.all(), at, overlay);
    marks::drawCells(context.document, layer, once, marks::kCursorFill, marks::kCursor, overlay);
    overlay.text(boxOfCell(context.document, layer, at).min, area.words, marks::kWords);
}

void TileTool::drawCursor(const ToolContext& context, const Pointer& pointer, CellPlace at,
                          Overlay& overlay) const {
    const Document& document = context.document;
    const ObjectId layer = activeTileLayer(document, context.tiles);
    const TileBrush now = brush(context);
    if (!now.ready()) return;
    const bool shaping = doing_ == Doing::Shaping;
    const bool erases = mode_ == Mode::Erase || (doing_ != Doing::Nothing && ink_ == TileInk::Nothing);
    std::vector<CellPlace> places = shaping ? shaped(now) : now.coveredAt(at);
    const bool line = !shaping && doing_ == Doing::Nothing && pointer.modifiers.shift &&
                      !pointer.modifiers.control && strokeEnd_ &&
                      (mode_ == Mode::Brush || mode_ == Mode::Erase);
    if (line) places = lineOfCells(*strokeEnd_, at);
    if (places.empty()) return;
    const CellPlace from = shaping ? start_ : line ? *strokeEnd_ : places.front();
    const CellPlace to = shaping ? last_ : places.back();
    const AABB box = now.onCorners() && !shaping ? marks::cornerBox(document, layer, at)
                                                 : boxOfCells(document, layer, from, to);
    if (mode_ != Mode::Fill && mode_ != Mode::Same && places.size() <= kMostGhosts) {
        CellSelection once;
        once.set(std::move(places));
        const CellPlace origin = doing_ == Doing::Nothing ? once.all().front()
                                 : doing_ == Doing::Shaping && shape_ != Mode::Line
                                     ? CellPlace{std::min(start_.x, last_.x), std::min(start_.y, last_.y)}
                                     : start_;
        drawGhost(context, now, once.all(), origin, overlay);
    } else {
        overlay.filledBox(box, marks::kCursorFill);
    }
    if (erases) overlay.filledBox(box, marks::kEraseFill);
    overlay.box(box, erases ? marks::kErase : marks::kCursor, 1.5f);
    if (shaping) marks::drawSize(box, from, to, overlay);
}

void TileTool::draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    const Document& document = context.document;
    const ObjectId layer = activeTileLayer(document, context.tiles);
    const TileGrid* grid = gridOf(document, layer);
    if (grid == nullptr) return;
    marks::drawLayer(context, layer, overlay);
    const CellPlace at = placeAt(context, pointer);
    if (doing_ == Doing::Picking || (doing_ == Doing::Nothing && picks(context, pointer))) {
        const bool picking = doing_ == Doing::Picking;
        const AABB box = boxOfCells(document, layer, picking ? start_ : at, picking ? last_ : at);
        overlay.filledBox(box, marks::kPickFill);
        overlay.box(box, marks::kPick, 1.5f);
        if (picking) marks::drawSize(box, start_, last_, overlay);
        return;
    }
    // While the button is held, the area is already filled.
    if (mode_ == Mode::Fill && doing_ == Doing::Nothing) return drawFill(context, pointer, overlay);
    drawCursor(context, pointer, at, overlay);
}

}  // namespace plumb::editor
