#include "editor/model/commands/paint_tiles.hpp"

#include <utility>

#include "editor/model/document/document.hpp"
#include "scene/components/drawing/tile_layer.hpp"

namespace plumb::editor {

void PaintTiles::Cells::swapWith(TileGrid& grid) {
    for (Cell& place : list) {
        const TileCell now = grid.at(place.x, place.y);
        grid.set(place.x, place.y, place.cell);
        place.cell = now;
    }
}

bool PaintTiles::Cells::markNew(const Cell& cell) {
    constexpr int kSide = TileGrid::kChunkSide;
    const std::uint64_t chunk = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.y / kSide)) << 32 |
                                static_cast<std::uint32_t>(cell.x / kSide);
    Marks& marks = known[chunk];
    const std::size_t slot = TileGrid::Chunk::slot(cell.x, cell.y);
    if (marks.test(slot)) return false;
    marks.set(slot);
    return true;
}

void PaintTiles::Cells::absorb(const Cells& later) {
    if (known.empty()) {
        for (const Cell& cell : list) markNew(cell);
    }
    // Undo restores each cell to its state before the stroke's first change of it; later changes are dropped.
    for (const Cell& cell : later.list) {
        if (markNew(cell)) list.push_back(cell);
    }
}

bool PaintTiles::absorb(const Command& next) {
    const auto* other = dynamic_cast<const PaintTiles*>(&next);
    if (other == nullptr || other->layer_ != layer_ || other->label_ != label_ ||
        other->newTerrain_ != nullptr)
        return false;
    cells_.absorb(other->cells_);
    terrain_.absorb(other->terrain_);
    return true;
}

void PaintTiles::apply(Document& document) {
    swapTerrain(document);
    swapCells(document);
}

void PaintTiles::revert(Document& document) {
    swapCells(document);
    swapTerrain(document);
}

void PaintTiles::swapCells(Document& document) {
    const TileLayer* layer = document.world.find<TileLayer>(document.find(layer_));
    PLUMB_ASSERT(layer != nullptr, "PaintTiles: the entity has no TileLayer");
    if (layer == nullptr) return;
    if (TileGrid* grid = document.world.tiles().edit(layer->cells)) cells_.swapWith(*grid);
    if (terrain_.list.empty()) return;
    if (TileGrid* grid = document.world.tiles().edit(layer->terrain)) terrain_.swapWith(*grid);
}

/// Swaps the id of the layer's terrain grid. Both grids stay in the world, so undo and redo only change the
/// id.
void PaintTiles::swapTerrain(Document& document) {
    if (newTerrain_ == nullptr) return;
    auto* layer = document.world.find<TileLayer>(document.find(layer_));
    if (layer == nullptr) return;
    if (!std::exchange(stored_, true)) otherTerrain_ = document.world.tiles().add(*newTerrain_);
    std::swap(layer->terrain, otherTerrain_);
}

}  // namespace plumb::editor
