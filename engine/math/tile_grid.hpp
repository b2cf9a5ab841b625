#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace plumb {

/// A cell of a tile layer: 0 is empty, else the tile's number in its tileset plus one, and how it is turned.
/// Applied in the order diagonal, horizontal, vertical.
using TileCell = std::uint32_t;

inline constexpr TileCell kTileFlipX = 0x80000000u;
inline constexpr TileCell kTileFlipY = 0x40000000u;
inline constexpr TileCell kTileFlipDiagonal = 0x20000000u;
inline constexpr TileCell kTileFlips = kTileFlipX | kTileFlipY | kTileFlipDiagonal;

constexpr int tileOf(TileCell cell) { return static_cast<int>(cell & ~kTileFlips) - 1; }  ///< -1 when empty
constexpr TileCell cellOf(int tile, TileCell flips = 0) { return static_cast<TileCell>(tile + 1) | flips; }

/// Cells in rows, top row first. `version` counts changes, so that what is derived from it can be kept.
class TileGrid {
public:
    TileGrid() = default;
    TileGrid(int width, int height)
        : width_{width}, height_{height}, cells_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] std::uint32_t version() const { return version_; }
    [[nodiscard]] const std::vector<TileCell>& cells() const { return cells_; }
    [[nodiscard]] bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

    /// The cell, or empty outside.
    [[nodiscard]] TileCell at(int x, int y) const { return has(x, y) ? cells_[slot(x, y)] : 0; }

    /// Outside the grid nothing happens.
    void set(int x, int y, TileCell cell) {
        if (has(x, y)) cells_[slot(x, y)] = cell, ++version_;
    }
    void replaceCells(int width, int height, std::vector<TileCell> cells) {
        width_ = width, height_ = height, cells_ = std::move(cells), ++version_;
    }

    friend bool operator==(const TileGrid& a, const TileGrid& b) {
        return a.width_ == b.width_ && a.height_ == b.height_ && a.cells_ == b.cells_;
    }

private:
    [[nodiscard]] std::size_t slot(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_ = 0;
    int height_ = 0;
    std::uint32_t version_ = 1;
    std::vector<TileCell> cells_;
};

}  // namespace plumb
