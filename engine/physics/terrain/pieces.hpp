#pragma once

#include <array>
#include <vector>

#include "physics/terrain/tile_mask.hpp"

namespace plumb::physics {

/// A convex part of a terrain's inside. Boxes of equal cells are merged; all others are one cell's own
/// outline.
struct TerrainPiece {
    GridPoint min;
    GridPoint max;  ///< of its bounds
    MaskCell cell;  ///< what it is made of, all of it

    friend bool operator==(const TerrainPiece&, const TerrainPiece&) = default;
};

/// The corners of a piece, clockwise on screen.
struct PieceCorners {
    std::array<GridPoint, TileOutline::kMaxCorners> points{};
    int count = 0;
};
PieceCorners cornersOf(const TerrainPiece& piece, const TilePalette& palette);

/// Makes pieces of chunks, and keeps its memory from one to the next.
class PieceBuilder {
public:
    /// Covers the solid cells of `rect` by pieces, each point of them once. One-way cells have no inside.
    /// Greedy: each box goes as far right, then as far down, as it can; rows first.
    void build(const TileMask& mask, CellRect rect, std::vector<TerrainPiece>& pieces);

private:
    [[nodiscard]] int runOf(std::size_t at, int most) const;

    std::vector<MaskCell> rest_;  // cells that no piece has yet
};

}  // namespace plumb::physics
