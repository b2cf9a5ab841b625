#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "physics/terrain/tile_palette.hpp"

namespace plumb::physics {

/// A cell of a terrain: numbers of its palette.
struct MaskCell {
    TileForm form = TileForm::Empty;
    std::uint8_t material = 0;
    std::uint8_t layers = 0;

    friend constexpr bool operator==(MaskCell, MaskCell) = default;
};
static_assert(sizeof(MaskCell) == 4, "a map of 4096 x 4096 has 16 million of them");

/// Whole cells from (x0, y0) up to, not including, (x1, y1).
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

/// A grid of cells and their palette: what a terrain is made from. Empty parts take no memory, and copies
/// share what is alike in them.
class TileMask {
public:
    static constexpr int kMaxSide = 65536;
    static constexpr int kMaxCells = 1 << 28;
    static constexpr int kChunkSide = 32;  ///< cells

    /// Cells in rows.
    using Chunk = std::array<MaskCell, std::size_t{kChunkSide} * kChunkSide>;

    TilePalette palette;

    TileMask() = default;
    /// All empty. Sides below 0 count as 0, above kMaxSide as kMaxSide; rows beyond kMaxCells are left out.
    TileMask(int width, int height);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

    /// The cell; beyond the border, outside().
    [[nodiscard]] MaskCell at(int x, int y) const {
        if (!has(x, y)) return outside_;
        const Chunk* chunk = chunks_[chunkOf(x, y)].get();
        return chunk == nullptr ? MaskCell{} : (*chunk)[slot(x, y)];
    }

    /// Beyond the border nothing happens.
    /// @return whether the cell is another one now
    /// @pre    the palette has what the cell names; one that it has not is not set
    bool set(int x, int y, MaskCell cell);

    /// Replaces all cells of a chunk, which begins at cell (column, row) * kChunkSide, at once. Those beyond
    /// the border are not looked at. Chunks of one cell all over are kept once for the whole mask.
    /// @pre the palette has what the cells name
    void putChunk(int column, int row, const Chunk& cells);
    /// The same with one cell all over.
    void putPlain(int column, int row, MaskCell cell);
    [[nodiscard]] int chunkColumns() const { return columns_; }
    [[nodiscard]] int chunkRows() const { return (height_ + kChunkSide - 1) / kChunkSide; }
    /// Whether all its cells are empty, told without looking at them: false says nothing.
    [[nodiscard]] bool isEmptyChunk(int column, int row) const { return chunkAt(column, row) == nullptr; }
    /// Whether it and all around it are of one full cell, told in the same way. @return that cell, else an
    /// empty one
    [[nodiscard]] MaskCell fullAround(int column, int row) const;

    /// What is beyond the border: empty by default, or full, so that the map ends in walls.
    [[nodiscard]] MaskCell outside() const { return outside_; }
    /// @pre the form is Empty or Full; others do not change it
    void setOutside(MaskCell cell);

    /// Copies the cells of a rectangle, row by row, with outside() where it reaches over the border.
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
        chunks_;                 // null: empty; shared with copies, so copied before a change
    std::vector<Plain> plains_;  // kept here, so that they are always shared and never changed
};

}  // namespace plumb::physics
