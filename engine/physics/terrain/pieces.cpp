#include "physics/terrain/pieces.hpp"

#include <algorithm>

namespace plumb::physics {

namespace {

/// The directions in which a form merges with equal cells.
struct Merging {
    bool right = false;
    bool down = false;
};

bool isBox(const TileOutline& outline) {
    if (outline.count != 4) return false;
    for (int i = 0; i < 4; ++i) {
        const GridPoint displacement = outline.cornerAfter(i) - outline.corner(i);
        if (displacement.x != 0 && displacement.y != 0) return false;
    }
    return true;
}

Merging mergingOf(const TileOutline& outline) {
    return {isBox(outline) && outline.spans[kLeft] == outline.spans[kRight] && !outline.spans[kLeft].empty(),
            isBox(outline) && outline.spans[kTop] == outline.spans[kBottom] && !outline.spans[kTop].empty()};
}

struct Bounds {
    GridPoint min{kCellUnits, kCellUnits};
    GridPoint max;
};

Bounds boundsOf(const TileOutline& outline) {
    Bounds bounds;
    for (int i = 0; i < outline.count; ++i) {
        const GridPoint corner = outline.corner(i);
        bounds.min = {std::min(bounds.min.x, corner.x), std::min(bounds.min.y, corner.y)};
        bounds.max = {std::max(bounds.max.x, corner.x), std::max(bounds.max.y, corner.y)};
    }
    return bounds;
}

}  // namespace

PieceCorners cornersOf(const TerrainPiece& piece, const TilePalette& palette) {
    const TileOutline& outline = palette.outline(piece.cell.form);
    if (isBox(outline)) {
        return {{piece.min, {piece.max.x, piece.min.y}, piece.max, {piece.min.x, piece.max.y}}, 4};
    }
    const GridPoint corner = cornerOfCell(piece.min.x / kCellUnits, piece.min.y / kCellUnits);
    PieceCorners corners;
    for (; corners.count < outline.count; ++corners.count) {
        corners.points[static_cast<std::size_t>(corners.count)] = corner + outline.corner(corners.count);
    }
    return corners;
}

/// The length of the run of equal cells that starts at `at`, at most `most`.
int PieceBuilder::runOf(std::size_t at, int maximum) const {
    int run = 1;
    while (run < maximum && rest_[at + static_cast<std::size_t>(run)] == rest_[at]) ++run;
    return run;
}

void PieceBuilder::build(const TileMask& mask, CellRect rect, std::vector<TerrainPiece>& pieces) {
    pieces.clear();
    mask.copyTo(rest_, rect);
    const auto width = static_cast<std::size_t>(rect.width());
    for (int y = rect.y0; y < rect.y1; ++y) {
        for (int x = rect.x0; x < rect.x1; ++x) {
            const std::size_t at =
                static_cast<std::size_t>(y - rect.y0) * width + static_cast<std::size_t>(x - rect.x0);
            const MaskCell cell = rest_[at];
            const TileOutline& outline = mask.palette.outline(cell.form);
            if (!outline.isSolid()) continue;
            const Merging merging = mergingOf(outline);
            const int columns = merging.right ? runOf(at, rect.x1 - x) : 1;
            int rows = 1;
            while (merging.down && y + rows < rect.y1) {
                const std::size_t below = at + static_cast<std::size_t>(rows) * width;
                if (rest_[below] != cell || runOf(below, columns) < columns) break;
                ++rows;
            }
            for (int row = 0; row < rows; ++row) {
                std::fill_n(
                    rest_.begin() + static_cast<std::ptrdiff_t>(at + static_cast<std::size_t>(row) * width),
                    columns, MaskCell{});
            }
            const Bounds bounds = boundsOf(outline);
            pieces.push_back({cornerOfCell(x, y) + bounds.min,
                              cornerOfCell(x + columns - 1, y + rows - 1) + bounds.max, cell});
        }
    }
}

}  // namespace plumb::physics
