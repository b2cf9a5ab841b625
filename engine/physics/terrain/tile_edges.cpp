#include "physics/terrain/tile_edges.hpp"

#include <algorithm>

namespace plumb::physics {

namespace {

/// The edge along a part of a side, clockwise.
TileEdge alongSide(GridPoint corner, Side side, FaceSpan span, EdgeKind kind) {
    switch (side) {
        case kTop: return {corner + GridPoint{span.from, 0}, corner + GridPoint{span.to, 0}, kind};
        case kRight:
            return {corner + GridPoint{kCellUnits, span.from}, corner + GridPoint{kCellUnits, span.to}, kind};
        case kBottom:
            return {corner + GridPoint{span.to, kCellUnits}, corner + GridPoint{span.from, kCellUnits}, kind};
        default: return {corner + GridPoint{0, span.to}, corner + GridPoint{0, span.from}, kind};
    }
}

class EdgesOfCell {
public:
    EdgesOfCell(const TilePalette& palette, const CellWindow& window, std::vector<TileEdge>& edges)
        : palette_{palette}, edges_{edges}, toNeighbour_{-window.width(), 1, window.width(), -1} {}

    void append(const TileCell* number, GridPoint corner) {
        const MaskCell cell = maskCellOf(*number);
        if (cell.form == TileForm::Full && isInside(number)) return;
        const TileOutline& outline = palette_.outline(cell.form);
        const EdgeKind kind{cell.material, cell.layers, outline.oneWay, 0};
        for (int i = 0; i < outline.count; ++i) {
            if ((outline.stops >> i & 1) == 0) continue;
            const Side side = outline.sides[static_cast<std::size_t>(i)];
            const GridPoint a = corner + outline.corner(i);
            const GridPoint b = corner + outline.cornerAfter(i);
            if (side == kInside) {
                edges_.push_back({a, b, kind});
            } else {
                const bool level = side == kTop || side == kBottom;
                const FaceSpan own =
                    level ? spanOf(a.x - corner.x, b.x - corner.x) : spanOf(a.y - corner.y, b.y - corner.y);
                appendSide(corner, side, own, kind, maskCellOf(number[toNeighbour_[side]]));
            }
        }
    }

private:
    static FaceSpan spanOf(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

    /// Fast path for the common case: a full cell among full cells with the same layers.
    [[nodiscard]] bool isInside(const TileCell* number) const {
        const std::uint8_t layers = maskCellOf(*number).layers;
        return std::all_of(std::begin(toNeighbour_), std::end(toNeighbour_), [&](std::ptrdiff_t step) {
            const MaskCell cell = maskCellOf(number[step]);
            return cell.form == TileForm::Full && cell.layers == layers;
        });
    }

    void appendSide(GridPoint corner, Side side, FaceSpan own, EdgeKind kind, MaskCell neighbour) {
        const FaceSpan other =
            palette_.outline(neighbour.form).spans[static_cast<std::size_t>((side + 2) % 4)];
        const FaceSpan both{std::max(own.from, other.from), std::min(own.to, other.to)};
        if (both.from > both.to) {
            edges_.push_back(alongSide(corner, side, own, kind));
            return;
        }
        // If the neighbour touches the side in a single point only, `both` is that point and the side is
        // split in two edges.
        const FaceSpan first{own.from, both.from};
        const FaceSpan last{both.to, own.to};
        if (!first.empty()) edges_.push_back(alongSide(corner, side, first, kind));
        if (!last.empty()) edges_.push_back(alongSide(corner, side, last, kind));
        if (!both.empty() && neighbour.layers != kind.layers &&
            !palette_.covers(neighbour.layers, kind.layers)) {
            kind.behind = static_cast<std::uint8_t>(neighbour.layers + 1);
            edges_.push_back(alongSide(corner, side, both, kind));
        }
    }

    const TilePalette& palette_;
    std::vector<TileEdge>& edges_;
    std::ptrdiff_t toNeighbour_[4];
};

}  // namespace

void CellWindow::read(const TileMask& mask, CellRect rect) {
    rect_ = rect;
    const auto width = static_cast<std::size_t>(rect.width());
    cells_.resize(width * static_cast<std::size_t>(rect.height()));
    TileCell* row = cells_.data();
    for (int y = rect.y0; y < rect.y1; ++y, row += width) mask.cells().copyRow(rect.x0, y, width, row);
}

bool CellWindow::isUniform() const {
    if (cells_.empty()) return true;
    const TileForm form = maskCellOf(cells_.front()).form;
    if (form != TileForm::Empty && form != TileForm::Full) return false;
    return std::all_of(cells_.begin(), cells_.end(), [&](TileCell cell) { return cell == cells_.front(); });
}

void appendEdges(const TilePalette& palette, const CellWindow& window, CellRect rect,
                 std::vector<TileEdge>& edges) {
    EdgesOfCell cells{palette, window, edges};
    for (int y = rect.y0; y < rect.y1; ++y) {
        const TileCell* number = window.cell(rect.x0, y);
        for (int x = rect.x0; x < rect.x1; ++x, ++number) {
            if (maskCellOf(*number).form != TileForm::Empty) cells.append(number, cornerOfCell(x, y));
        }
    }
}

}  // namespace plumb::physics
