#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "physics/terrain/tile_palette.hpp"

namespace plumb::physics {

/// A cell of a terrain: indices in its palette.
struct MaskCell {
    TileForm form = TileForm::Empty;
    std::uint8_t material = 0;
    std::uint8_t layers = 0;

    friend constexpr bool operator==(MaskCell, MaskCell) = default;
};
static_assert(sizeof(MaskCell) == 4, "a map of 4096 x 4096 has 16 million of them");

/// The cells from (x0, y0) to (x1, y1), excluding the latter.
struct CellRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    [[nodiscard]] constexpr int width() const { return x1 - x0; }
    [[nodiscard]] constexpr int height() const { return y1 - y0; }
    [[nodiscard]] constexpr bool has(int x, int y) const { return x >= x0 && y >= y0 && x < x1 && y < y1; }
    [[nodiscard]] constexpr CellRect grown(int by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
    friend constexpr bool operator==(CellRect, CellRect) = default;
};

/// A grid of cells and their palette, from which a terrain is built. Empty parts use no memory, and copies
/// share equal parts.
class TileMask {
public:
    static constexpr int kMaxSide = 65536;
    static constexpr int kMaxCells = 1 << 28;
    static constexpr int kChunkSide = 32;  ///< cells

    /// Cells, row by row.
    using Chunk = std::array<MaskCell, std::size_t{kChunkSide} * kChunkSide>;

    TilePalette palette;

    TileMask() = default;
    /// All cells are empty. Sides are clamped to 0..kMaxSide; rows beyond kMaxCells are dropped.
    TileMask(int width, int height);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

    /// The cell; outside the grid, outside().
    [[nodiscard]] MaskCell at(int x, int y) const {
        if (!has(x, y)) return outside_;
        const Chunk* chunk = chunks_[chunkOf(x, y)].get();
        return chunk == nullptr ? MaskCell{} : (*chunk)[slot(x, y)];
    }

    /// Does nothing outside the grid.
    /// @return true if the cell changed
    /// @pre    the cell's form, material and layers are in the palette; otherwise it is not set
    bool set(int x, int y, MaskCell cell);

    /// Replaces all cells of a chunk at once; its first cell is (column, row) * kChunkSide. Cells outside the
    /// grid are ignored. Uniform chunks with equal cells share their memory.
    /// @pre the cells' forms, materials and layers are in the palette
    void putChunk(int column, int row, const Chunk& cells);
    /// The same with equal cells.
    void putPlain(int column, int row, MaskCell cell);
    [[nodiscard]] int chunkColumns() const { return columns_; }
    [[nodiscard]] int chunkRows() const { return (height_ + kChunkSide - 1) / kChunkSide; }
    /// Fast check that all cells of a chunk are empty. May return false although they are.
    [[nodiscard]] bool isEmptyChunk(int column, int row) const { return chunkAt(column, row) == nullptr; }
    /// The cell value if the chunk and its eight neighbours are uniformly the same full cell, otherwise an
    /// empty cell. A fast check like isEmptyChunk(): may return an empty cell although they are.
    [[nodiscard]] MaskCell fullAround(int column, int row) const;

    /// The cells outside the grid: empty by default, or full, so that the map ends in walls.
    [[nodiscard]] MaskCell outside() const { return outside_; }
    /// @pre the form is Empty or Full; otherwise nothing changes
    void setOutside(MaskCell cell);

    /// Copies the cells of a rectangle, row by row, with outside() for those outside the grid.
    void copyTo(std::vector<MaskCell>& cells, CellRect rect) const;

private:
    static constexpr int kSide = kChunkSide;
    struct Plain {
        MaskCell cell;
        std::shared_ptr<Chunk> chunk;
    };

    [[nodiscard]] const Chunk* chunkAt(int column, int row) const {
        return chunks_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(column)]
            .get();
    }

    [[nodiscard]] std::size_t chunkOf(int x, int y) const {
        return static_cast<std::size_t>(y / kSide) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(x / kSide);
    }
    [[nodiscard]] static std::size_t slot(int x, int y) {
        return static_cast<std::size_t>(y % kSide) * kSide + static_cast<std::size_t>(x % kSide);
    }
    [[nodiscard]] bool knows(MaskCell cell) const {
        return palette.hasForm(cell.form) && palette.hasMaterial(cell.material) &&
               palette.hasLayers(cell.layers);
    }

    int width_ = 0;
    int height_ = 0;
    int columns_ = 0;
    MaskCell outside_;
    std::vector<std::shared_ptr<Chunk>>
        chunks_;                 // null: empty. Shared with copies, so a chunk is copied before it changes
    std::vector<Plain> plains_;  // holds a reference to each uniform chunk, so that it counts as shared and
                                 // is never modified
};

}  // namespace plumb::physics
