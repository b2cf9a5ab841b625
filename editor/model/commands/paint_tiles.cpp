#include "editor/model/commands/paint_tiles.hpp"

#include "editor/model/document.hpp"
#include "scene/components/tile_layer.hpp"

namespace plumb::editor {

bool PaintTiles::absorb(const Command& next) {
    const auto* other = dynamic_cast<const PaintTiles*>(&next);
    if (other == nullptr || other->layer_ != layer_) return false;
    cells_.insert(cells_.end(), other->cells_.begin(), other->cells_.end());
    return true;
}

void PaintTiles::swapCells(Document& document, bool backwards) {
    const TileLayer* layer = document.world.find<TileLayer>(document.find(layer_));
    TileGrid* grid = layer == nullptr ? nullptr : document.world.tiles().edit(layer->cells);
    PLUMB_ASSERT(grid != nullptr, "PaintTiles on an entity without tiles");
    if (grid == nullptr) return;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        Cell& place = cells_[backwards ? cells_.size() - 1 - i : i];
        const TileCell now = grid->at(place.x, place.y);
        grid->set(place.x, place.y, place.cell);
        place.cell = now;
    }
}

std::vector<PaintTiles::Cell> connectedCells(const TileGrid& grid, int x, int y) {
    std::vector<PaintTiles::Cell> filled;
    if (!grid.has(x, y)) return filled;
    const TileCell from = grid.at(x, y);
    const auto width = static_cast<std::size_t>(grid.width());
    std::vector<bool> seen(width * static_cast<std::size_t>(grid.height()));
    const auto visit = [&](int atX, int atY) {
        if (!grid.has(atX, atY) || grid.at(atX, atY) != from) return;
        const std::size_t slot = static_cast<std::size_t>(atY) * width + static_cast<std::size_t>(atX);
        if (seen[slot]) return;
        seen[slot] = true;
        filled.push_back({atX, atY, from});
    };
    visit(x, y);
    for (std::size_t i = 0; i < filled.size(); ++i) {
        const PaintTiles::Cell at = filled[i];
        visit(at.x - 1, at.y);
        visit(at.x + 1, at.y);
        visit(at.x, at.y - 1);
        visit(at.x, at.y + 1);
    }
    return filled;
}

}  // namespace plumb::editor
