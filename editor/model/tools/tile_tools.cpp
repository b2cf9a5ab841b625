#include "editor/model/tools/tile_tools.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "scene/components/tile_collider.hpp"
#include "scene/components/tile_layer.hpp"
#include "scene/tile_bodies.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

constexpr Color kCursor{77, 163, 255, 255};
constexpr Color kCursorFill{77, 163, 255, 50};
constexpr Color kErase{240, 104, 104, 255};
constexpr Color kEraseFill{240, 104, 104, 50};
constexpr Color kPick{255, 221, 87, 255};
constexpr Color kPickFill{255, 221, 87, 40};
constexpr Color kGhost{255, 255, 255, 190};
constexpr Color kLayer{226, 164, 96, 150};
constexpr float kFarCell = 1e6f;  // cells; farther away is the same to us

struct LayerPlace {
    Vec2 origin;
    Vec2 tile{16.0f, 16.0f};
};

LayerPlace placeOf(const Document& document, ObjectId layer) {
    const EntityId entity = document.find(layer);
    const Pose pose = worldPose(document.world, entity);
    const TileLayer* tiles = document.world.find<TileLayer>(entity);
    const Vec2 tile = tiles == nullptr ? Vec2{} : scaled(tileSizeOf(document.world, *tiles), pose.scale);
    LayerPlace place{pose.position};
    if (tile.x > 0.0f && tile.y > 0.0f) place.tile = tile;
    return place;
}

const TileGrid* gridOf(const Document& document, ObjectId layer) {
    const TileLayer* tiles = document.world.find<TileLayer>(document.find(layer));
    return tiles == nullptr ? nullptr : document.world.tiles().find(tiles->cells);
}

AABB boxOfCells(const Document& document, ObjectId layer, CellPlace a, CellPlace b) {
    return merged(boxOfCell(document, layer, a), boxOfCell(document, layer, b));
}

int wrapped(int value, int size) { return ((value % size) + size) % size; }

}  // namespace

ObjectId activeTileLayer(const Document& document, const TilePaint& paint) {
    const auto isLayer = [&](ObjectId id) { return document.world.has<TileLayer>(document.find(id)); };
    for (const ObjectId id : document.selection.all()) {
        if (isLayer(id)) return id;
    }
    if (isLayer(paint.layer)) return paint.layer;
    ObjectId first;
    for (const ObjectId id : document.objects()) {
        if (!isLayer(id)) continue;
        if (document.world.has<TileCollider>(document.find(id))) return id;
        if (!first) first = id;
    }
    return first;
}

CellPlace cellAt(const Document& document, ObjectId layer, Vec2 point) {
    const LayerPlace place = placeOf(document, layer);
    const Vec2 at = point - place.origin;
    const auto cell = [](float part) {
        return static_cast<int>(std::floor(std::fmin(std::fmax(part, -kFarCell), kFarCell)));
    };
    return {cell(at.x / place.tile.x), cell(at.y / place.tile.y)};
}

AABB boxOfCell(const Document& document, ObjectId layer, CellPlace cell) {
    const LayerPlace place = placeOf(document, layer);
    const Vec2 from =
        place.origin + scaled({static_cast<float>(cell.x), static_cast<float>(cell.y)}, place.tile);
    return {from, from + place.tile};
}

std::string_view TileTool::next() const { return mode_ == Mode::Pick ? "tool.brush" : ""; }

void TileTool::press(const ToolContext& context, const Pointer& pointer) {
    const ObjectId layer = activeTileLayer(context.document, context.tiles);
    if (gridOf(context.document, layer) == nullptr) return;
    context.tiles.layer = layer;
    start_ = last_ = cellAt(context.document, layer, pointer.position);
    if (mode_ == Mode::Pick || pointer.modifiers.alt || pointer.secondary) {
        doing_ = Doing::Picking;
    } else if (mode_ == Mode::Rectangle) {
        doing_ = Doing::Boxing;
    } else {
        doing_ = Doing::Painting;
        if (mode_ == Mode::Fill) return fillConnected(context, start_);
        paintLine(context, pointer.modifiers.shift ? strokeEnd_.value_or(start_) : start_, start_);
    }
}

void TileTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (doing_ == Doing::Nothing) return;
    const CellPlace at = cellAt(context.document, context.tiles.layer, pointer.position);
    if (doing_ == Doing::Painting && mode_ != Mode::Fill && at != last_) paintLine(context, last_, at);
    last_ = at;
}

void TileTool::release(const ToolContext& context, const Pointer&) {
    if (doing_ == Doing::Boxing) fillBox(context);
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

std::vector<PaintTiles::Cell> TileTool::stampAt(const ToolContext& context, CellPlace at) const {
    if (mode_ == Mode::Erase) return {{at.x, at.y, 0}};
    const TileStamp& stamp = context.tiles.stamp;
    std::vector<PaintTiles::Cell> cells;
    for (int y = 0; y < stamp.height; ++y) {
        for (int x = 0; x < stamp.width; ++x) {
            // A pattern keeps its rhythm all along the stroke, instead of being cut up by itself.
            const TileCell cell = stamp.at(wrapped(at.x + x - start_.x, stamp.width),
                                           wrapped(at.y + y - start_.y, stamp.height));
            if (cell != 0 || stamp.single()) cells.push_back({at.x + x, at.y + y, cell});
        }
    }
    return cells;
}

void TileTool::paintLine(const ToolContext& context, CellPlace from, CellPlace to) const {
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    for (int i = 0; i <= steps; ++i) {
        // Fast strokes leave no holes: every cell on the way.
        const int x = steps == 0 ? from.x : from.x + (to.x - from.x) * i / steps;
        const int y = steps == 0 ? from.y : from.y + (to.y - from.y) * i / steps;
        paint(context, stampAt(context, {x, y}));
    }
}

void TileTool::paint(const ToolContext& context, std::vector<PaintTiles::Cell> cells) const {
    const TileGrid* grid = gridOf(context.document, context.tiles.layer);
    if (grid == nullptr) return;
    std::erase_if(cells, [&](const PaintTiles::Cell& cell) {
        return !grid->has(cell.x, cell.y) || grid->at(cell.x, cell.y) == cell.cell;
    });
    if (!cells.empty())
        context.undo.push(std::make_unique<PaintTiles>(context.tiles.layer, std::move(cells)));
}

void TileTool::fillBox(const ToolContext& context) const {
    const TileStamp& stamp = context.tiles.stamp;
    const CellPlace from{std::min(start_.x, last_.x), std::min(start_.y, last_.y)};
    std::vector<PaintTiles::Cell> cells;
    const TileGrid* grid = gridOf(context.document, context.tiles.layer);
    if (grid == nullptr) return;
    for (int y = std::max(from.y, 0); y <= std::min(std::max(start_.y, last_.y), grid->height() - 1); ++y) {
        for (int x = std::max(from.x, 0); x <= std::min(std::max(start_.x, last_.x), grid->width() - 1);
             ++x) {
            const TileCell cell =
                stamp.at(wrapped(x - from.x, stamp.width), wrapped(y - from.y, stamp.height));
            if (cell != 0 || stamp.single()) cells.push_back({x, y, cell});
        }
    }
    paint(context, std::move(cells));
}

void TileTool::fillConnected(const ToolContext& context, CellPlace at) const {
    const TileGrid* grid = gridOf(context.document, context.tiles.layer);
    const TileStamp& stamp = context.tiles.stamp;
    std::vector<PaintTiles::Cell> cells = connectedCells(*grid, at.x, at.y);
    for (PaintTiles::Cell& cell : cells) {
        cell.cell = stamp.at(wrapped(cell.x - at.x, stamp.width), wrapped(cell.y - at.y, stamp.height));
    }
    if (!stamp.single()) std::erase_if(cells, [](const PaintTiles::Cell& cell) { return cell.cell == 0; });
    paint(context, std::move(cells));
}

void TileTool::pick(const ToolContext& context) const {
    const TileGrid* grid = gridOf(context.document, context.tiles.layer);
    if (grid != nullptr) context.tiles.stamp = stampFrom(*grid, start_, last_);
}

/// What a click would paint here.
void TileTool::drawGhost(const ToolContext& context, CellPlace at, Overlay& overlay) const {
    const Document& document = context.document;
    const ObjectId layer = activeTileLayer(document, context.tiles);
    const TileLayer* tiles = document.world.find<TileLayer>(document.find(layer));
    const TileStamp& stamp = context.tiles.stamp;
    const CellPlace from = doing_ == Doing::Nothing ? at : start_;
    for (int i = 0; i < stamp.width * stamp.height; ++i) {
        const CellPlace place{at.x + i % stamp.width, at.y + i / stamp.width};
        const TileCell cell =
            stamp.at(wrapped(place.x - from.x, stamp.width), wrapped(place.y - from.y, stamp.height));
        if (cell != 0) overlay.tile(boxOfCell(document, layer, place), tiles->tileset, cell, kGhost);
    }
}

void TileTool::draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    const Document& document = context.document;
    const ObjectId layer = activeTileLayer(document, context.tiles);
    const TileGrid* grid = gridOf(document, layer);
    if (grid == nullptr) return;
    if (grid->width() > 0 && grid->height() > 0) {
        overlay.box(boxOfCells(document, layer, {0, 0}, {grid->width() - 1, grid->height() - 1}), kLayer);
    }
    const CellPlace at = cellAt(document, layer, pointer.position);
    const bool picks = doing_ == Doing::Picking || mode_ == Mode::Pick ||
                       (doing_ == Doing::Nothing && pointer.modifiers.alt);
    CellPlace from = at;
    CellPlace to = at;
    if (doing_ == Doing::Boxing || doing_ == Doing::Picking) {
        from = start_;
        to = last_;
    } else if (!picks && mode_ == Mode::Brush) {
        drawGhost(context, at, overlay);
        to = {at.x + context.tiles.stamp.width - 1, at.y + context.tiles.stamp.height - 1};
    }
    const bool erases = !picks && mode_ == Mode::Erase;
    const AABB box = boxOfCells(document, layer, from, to);
    const bool ghost = !picks && mode_ == Mode::Brush;
    if (!ghost) overlay.filledBox(box, picks ? kPickFill : erases ? kEraseFill : kCursorFill);
    overlay.box(box, picks ? kPick : erases ? kErase : kCursor, 1.5f);
}

}  // namespace plumb::editor
