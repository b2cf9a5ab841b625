#pragma once

#include <cstdint>
#include <vector>

#include "physics/terrain/tile_mask.hpp"

namespace plumb::physics {

/// What an edge of a terrain is made of. Edges differ in it are never merged.
struct EdgeKind {
    std::uint8_t material = 0;  ///< number in the palette
    std::uint8_t layers = 0;    ///< number in the palette
    OneWay oneWay = OneWay::No;
    /// An inner border: this plus 1 is the number of the layers of the cell in front. The edge stops only who
    /// does not meet those; all others never come to it.
    std::uint8_t behind = 0;

    [[nodiscard]] bool isInner() const { return behind != 0; }
    /// Solid and in nobody's inside: these edges form closed outlines.
    [[nodiscard]] bool isPlain() const { return behind == 0 && oneWay == OneWay::No; }
    friend constexpr bool operator==(EdgeKind, EdgeKind) = default;
};

/// A part of a cell's outline that bodies can touch. Whoever walks from a to b has the solid on the right
/// hand of the screen and the normal on the left, see normalOfChain().
struct TileEdge {
    GridPoint a;
    GridPoint b;
    EdgeKind kind;
};

/// A copy of the cells that one chunk's outlines depend on.
class CellWindow {
public:
    void read(const TileMask& mask, CellRect rect) {
        rect_ = rect;
        mask.copyTo(cells_, rect);
    }
    [[nodiscard]] MaskCell at(int x, int y) const { return *cell(x, y); }
    /// The next row's cell is `width()` further.
    [[nodiscard]] const MaskCell* cell(int x, int y) const {
        return cells_.data() + std::ptrdiff_t{y - rect_.y0} * rect_.width() + (x - rect_.x0);
    }
    [[nodiscard]] int width() const { return rect_.width(); }
    /// All cells are the same and have no edges among them.
    [[nodiscard]] bool isUniform() const;

private:
    CellRect rect_;
    std::vector<MaskCell> cells_;
};

/// Appends the edges of the cells of `rect`, row by row, each cell's clockwise. A side is an edge where it is
/// open: where the cell next to it does not fill it, or where other layers do.
/// @pre the window reaches one cell beyond `rect`
void appendEdges(const TilePalette& palette, const CellWindow& window, CellRect rect,
                 std::vector<TileEdge>& edges);

}  // namespace plumb::physics
