#pragma once

#include <array>
#include <vector>

#include "physics/terrain/tile_mask.hpp"

namespace plumb::physics {

/// A convex part of the inside of a terrain. Equal box-shaped cells are merged; any other piece is the
/// outline of a single cell.
struct TerrainPiece {
    GridPoint min;
    GridPoint max;  ///< of its bounds, as `min`
    MaskCell cell;  ///< the kind of its cells

    friend bool operator==(const TerrainPiece&, const TerrainPiece&) = default;
};

/// The corners of a piece, clockwise on screen.
struct PieceCorners {
    std::array<GridPoint, TileOutline::kMaxCorners> points{};
    int count = 0;
};
PieceCorners cornersOf(const TerrainPiece& piece, const TilePalette& palette);

/// Builds the pieces of chunks, and keeps its memory from one to the next.
class PieceBuilder {
public:
    /// Covers the solid cells of `rect` with pieces that do not overlap. One-way cells have no inside.
    /// Greedy: each box extends to the right as far as possible, then down; cells are visited row by row.
    void build(const TileMask& mask, CellRect rect, std::vector<TerrainPiece>& pieces);

private:
    [[nodiscard]] int runOf(std::size_t at, int maximum) const;

    std::vector<MaskCell> rest_;  // cells that are not in a piece yet
};

}  // namespace plumb::physics
