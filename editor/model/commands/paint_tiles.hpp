#pragma once

#include <vector>

#include "editor/model/command.hpp"
#include "editor/model/object_id.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor {

/// Changes cells of one tile layer. A stroke melts into one step.
class PaintTiles final : public Command {
public:
    struct Cell {
        int x = 0;
        int y = 0;
        TileCell cell = 0;
    };

    /// @param cells  each place once; those outside the layer are left out
    PaintTiles(ObjectId layer, std::vector<Cell> cells) : layer_{layer}, cells_{std::move(cells)} {}

    [[nodiscard]] std::string label() const override { return "paint tiles"; }
    void apply(Document& document) override { swapCells(document, false); }
    void revert(Document& document) override { swapCells(document, true); }
    bool absorb(const Command& next) override;

private:
    void swapCells(Document& document, bool backwards);

    ObjectId layer_;
    std::vector<Cell> cells_;  // what is not in the document now; later ones of a stroke may repeat a place
};

/// The cells that a bucket fills: those connected to (x, y) through equal neighbours, as they are.
std::vector<PaintTiles::Cell> connectedCells(const TileGrid& grid, int x, int y);

}  // namespace plumb::editor
