#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace plumb {

/// A cell of a tile layer: 0 if it is empty, else the tile's index in its tileset
/// plus one, and flip bits. Flips are applied in the order diagonal, horizontal, vertical.
using TileCell = std::uint32_t;

inline constexpr TileCell kTileFlipX = 0x80000000u;
inline constexpr TileCell kTileFlipY = 0x40000000u;
inline constexpr TileCell kTileFlipDiagonal = 0x20000000u;
inline constexpr TileCell kTileFlips = kTileFlipX | kTileFlipY | kTileFlipDiagonal;

constexpr int tileOf(TileCell cell) { return static_cast<int>(cell & ~kTileFlips) - 1; }  ///< -1 when empty
constexpr TileCell cellOf(int tile, TileCell flips = 0) { return static_cast<TileCell>(tile + 1) | flips; }

/// Cells in rows, top row first, stored in chunks: an empty chunk takes no
/// memory, and copies of a grid share equal chunks. `version` and the stamps
/// of rows of chunks show what changed, so that derived data can be cached.
class TileGrid {
public:
    static constexpr int kChunkSide = 32;  ///< cells

    /// Cells in rows. Those outside the grid are empty.
    struct Chunk {
        std::array<TileCell, std::size_t{kChunkSide} * kChunkSide> cells{};
        std::uint64_t stamp = 0;  ///< stamp of the last change; unique within the program

        [[nodiscard]] TileCell at(int x, int y) const { return cells[slot(x, y)]; }
        static constexpr std::size_t slot(int x, int y) {
            constexpr auto kMask = static_cast<unsigned>(kChunkSide - 1);
            return (static_cast<unsigned>(y) & kMask) * std::size_t{kChunkSide} +
                   (static_cast<unsigned>(x) & kMask);
        }
    };

    TileGrid() = default;
    TileGrid(int width, int height);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] std::size_t cellCount() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }
    [[nodiscard]] std::uint32_t version() const { return version_; }
    [[nodiscard]] bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

    /// The cell, or empty outside the grid.
    [[nodiscard]] TileCell at(int x, int y) const {
        if (!has(x, y)) return 0;
        const Chunk* chunk = chunks_[chunkAt(x, y)].get();
        return chunk == nullptr ? 0 : chunk->at(x, y);
    }
    /// Sets a cell; does nothing outside the grid.
    void set(int x, int y, TileCell cell);
    void replaceCells(int width, int height, const std::vector<TileCell>& cells);  ///< size and content

    /// Returns all cells row by row; only for small grids.
    [[nodiscard]] std::vector<TileCell> cells() const;
    /// Copies cells (x .. x + count - 1, y); those outside the grid are empty.
    void copyRow(int x, int y, std::size_t count, TileCell* into) const;

    // Chunks. Chunk (column, row) begins at cell (column, row) * kChunkSide.

    [[nodiscard]] int chunkColumns() const { return columns_; }
    [[nodiscard]] int chunkRows() const { return rows_; }
    /// A null chunk is empty; an empty chunk is not always null.
    [[nodiscard]] const Chunk* chunk(int column, int row) const {
        return chunks_[chunkSlot(column, row)].get();
    }
    /// Changes with every change of a cell in this row of chunks.
    [[nodiscard]] std::uint64_t rowStamp(int row) const { return rowStamps_[static_cast<std::size_t>(row)]; }
    /// Creates a chunk of equal cells, which many positions may share.
    [[nodiscard]] static std::shared_ptr<Chunk> filled(TileCell cell);
    void put(int column, int row, std::shared_ptr<Chunk> chunk);  ///< replaces one chunk
    /// Copies one chunk from a grid of the same size, and the stamp of its row.
    void adopt(const TileGrid& from, int column, int row);

    friend bool operator==(const TileGrid& a, const TileGrid& b);

private:
    [[nodiscard]] std::size_t chunkSlot(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] std::size_t chunkAt(int x, int y) const {
        return chunkSlot(x / kChunkSide, y / kChunkSide);
    }
    [[nodiscard]] static std::uint64_t nextStamp() {
        return stamps_.fetch_add(1, std::memory_order_relaxed) + 1;
    }

    static inline std::atomic<std::uint64_t> stamps_{0};

    int width_ = 0;
    int height_ = 0;
    int columns_ = 0;
    int rows_ = 0;
    std::uint32_t version_ = 1;
    std::vector<std::shared_ptr<Chunk>> chunks_;  // shared with copies, so copied before a change
    std::vector<std::uint64_t> rowStamps_;
};

}  // namespace plumb
