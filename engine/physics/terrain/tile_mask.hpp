#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "math/tile_grid.hpp"
#include "physics/terrain/tile_palette.hpp"

namespace plumb::physics {

/// A cell of a terrain: indices in its palette. A TileGrid holds it as a number, which is 0 for an empty
/// cell.
struct MaskCell {
    TileForm form = TileForm::Empty;
    std::uint8_t material = 0;
    std::uint8_t layers = 0;

    friend constexpr bool operator==(MaskCell, MaskCell) = default;
};
constexpr MaskCell maskCellOf(TileCell number) { return std::bit_cast<MaskCell>(number); }
constexpr TileCell numberOf(MaskCell cell) { return std::bit_cast<TileCell>(cell); }

/// The cells from (x0, y0) to (x1, y1), excluding the latter.
struct CellRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    [[nodiscard]] constexpr int width() const { return x1 - x0; }
    [[nodiscard]] constexpr int height() const { return y1 - y0; }
    [[nodiscard]] constexpr CellRect grown(int by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
};

/// A grid of cells and their palette, from which a terrain is built. Outside of it all cells are empty.
class TileMask {
public:
    static constexpr int kMaxSide = 65536;
    static constexpr int kMaxCells = 1 << 28;

    /// Cells, row by row.
    using Chunk = std::array<MaskCell, std::size_t{TileGrid::kChunkSide} * TileGrid::kChunkSide>;

    TilePalette palette;

    TileMask() = default;
    /// All cells are empty. Sides are clamped to 0..kMaxSide; rows beyond kMaxCells are dropped.
    TileMask(int width, int height);

    /// The numbers of all cells.
    [[nodiscard]] const TileGrid& cells() const { return cells_; }
    [[nodiscard]] int width() const { return cells_.width(); }
    [[nodiscard]] int height() const { return cells_.height(); }
    [[nodiscard]] MaskCell at(int x, int y) const { return maskCellOf(cells_.at(x, y)); }

    /// Does nothing outside the grid.
    /// @return true if the cell changed
    /// @pre    the cell's form, material and layers are in the palette; otherwise it is not set
    bool set(int x, int y, MaskCell cell);

    /// Replaces all cells of a chunk at once; its first cell is (column, row) * TileGrid::kChunkSide. Cells
    /// outside the grid are ignored. Uniform chunks with equal cells share their memory.
    /// @pre the cells' forms, materials and layers are in the palette
    void putChunk(int column, int row, const Chunk& cells);
    /// The same with equal cells.
    void putPlain(int column, int row, MaskCell cell);
    /// Fast check that a chunk has no edges: it is empty, or it and its eight neighbours are uniformly the
    /// same full cell. May return false although they are.
    [[nodiscard]] bool isPlain(int column, int row) const;

private:
    [[nodiscard]] bool knows(MaskCell cell) const {
        return palette.hasForm(cell.form) && palette.hasMaterial(cell.material) &&
               palette.hasLayers(cell.layers);
    }

    TileGrid cells_;
    /// Each uniform chunk; so they count as shared and are never modified.
    std::vector<std::shared_ptr<TileGrid::Chunk>> plains_;
};

}  // namespace plumb::physics
