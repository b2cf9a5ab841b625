#pragma once

#include <cstdint>
#include <vector>

#include "physics/terrain/tile_mask.hpp"

namespace plumb::physics {

/// The properties of an edge. Edges with different properties are never merged.
struct EdgeKind {
    std::uint8_t material = 0;  ///< index in the palette
    std::uint8_t layers = 0;    ///< index in the palette
    OneWay oneWay = OneWay::No;
    /// Nonzero for an inner border: 1 + the index of the layers of the cell in front. The edge only stops
    /// bodies that do not collide with those layers; all others are stopped before they reach it.
    std::uint8_t behind = 0;

    [[nodiscard]] bool isInner() const { return behind != 0; }
    /// A solid edge that faces open space: these edges form closed outlines.
    [[nodiscard]] bool isPlain() const { return behind == 0 && oneWay == OneWay::No; }
    friend constexpr bool operator==(EdgeKind, EdgeKind) = default;
};

/// A part of a cell's outline that bodies can touch. Seen along the direction from a to b on screen (y down),
/// the solid is on the right and the normal points to the left, see normalOfChain().
struct TileEdge {
    GridPoint a;
    GridPoint b;
    EdgeKind kind;

    /// Its start (0) or its end (1).
    [[nodiscard]] constexpr GridPoint end(std::size_t i) const { return i == 0 ? a : b; }
};

/// A copy of the cells that the outlines of one chunk depend on.
class CellWindow {
public:
    void read(const TileMask& mask, CellRect rect);
    /// The number of a cell, see MaskCell; that of the cell below is `width()` further.
    [[nodiscard]] const TileCell* cell(int x, int y) const {
        return cells_.data() + std::ptrdiff_t{y - rect_.y0} * rect_.width() + (x - rect_.x0);
    }
    [[nodiscard]] int width() const { return rect_.width(); }
    /// True if all cells are equal and there are no edges between them.
    [[nodiscard]] bool isUniform() const;

private:
    CellRect rect_;
    std::vector<TileCell> cells_;
};

/// Appends the edges of the cells of `rect`, row by row, clockwise for each cell. A side is an edge where it
/// is open: where the neighbouring cell does not fill it, or fills it with other layers.
/// @pre the window extends one cell beyond `rect`
void appendEdges(const TilePalette& palette, const CellWindow& window, CellRect rect,
                 std::vector<TileEdge>& edges);

}  // namespace plumb::physics
