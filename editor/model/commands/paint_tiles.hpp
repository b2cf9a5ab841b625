#pragma once

#include <bitset>
#include <memory>
#include <unordered_map>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/object_id.hpp"
#include "math/tile_grid.hpp"
#include "reflect/field_types.hpp"

namespace plumb::editor {

/// Changes cells of one tile layer and its terrain. The commands of a stroke merge into one step, whose
/// memory depends on the number of changed cells, not on how often the stroke passed over them.
class PaintTiles final : public Command {
public:
    struct Cell {
        int x = 0;
        int y = 0;
        TileCell cell = 0;
    };
    /// Cells to change, each at most once; cells outside the layer are left out.
    struct Change {
        std::vector<Cell> cells;
        std::vector<Cell> terrain;             ///< terrain ids
        std::shared_ptr<TileGrid> newTerrain;  ///< initial terrain grid for a layer without one

        [[nodiscard]] bool empty() const { return cells.empty() && terrain.empty(); }
    };

    PaintTiles(ObjectId layer, std::vector<Cell> cells)
        : PaintTiles{layer, Change{std::move(cells), {}, nullptr}} {}
    PaintTiles(ObjectId layer, Change change, std::string label = "paint tiles")
        : layer_{layer}, label_{std::move(label)}, newTerrain_{std::move(change.newTerrain)} {
        cells_.list = std::move(change.cells);
        terrain_.list = std::move(change.terrain);
    }

    [[nodiscard]] std::string label() const override { return label_; }
    [[nodiscard]] Subject subject() const override { return {layer_, 1}; }
    void apply(Document& document) override;
    void revert(Document& document) override;
    bool absorb(const Command& next) override;

private:
    /// Cells to swap in: the new ones, after `apply` the old ones.
    struct Cells {
        using Marks = std::bitset<std::size_t{TileGrid::kChunkSide} * TileGrid::kChunkSide>;
        std::vector<Cell> list;
        std::unordered_map<std::uint64_t, Marks>
            known;  // by chunk: cells in `list`, filled by the first `absorb`
        void swapWith(TileGrid& grid);
        void absorb(const Cells& later);
        bool markNew(const Cell& cell);
    };
    void swapCells(Document& document);
    void swapTerrain(Document& document);

    ObjectId layer_;
    std::string label_;
    std::shared_ptr<TileGrid> newTerrain_;
    TilesId otherTerrain_;  // terrain grid to swap in: the new one, after `apply` the old one
    bool stored_ = false;   // `newTerrain_` was added to the world's grids
    Cells cells_;
    Cells terrain_;
};

}  // namespace plumb::editor
