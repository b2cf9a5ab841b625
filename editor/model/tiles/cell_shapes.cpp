#include "editor/model/tiles/cell_shapes.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace plumb::editor {
namespace {

/// The key that two equal cells share: the terrain id, or the tile where there is no terrain.
class CellKeys {
public:
    CellKeys(const TileGrid& grid, const TileGrid* terrain) : grid_{grid}, terrain_{terrain} {}

    [[nodiscard]] std::uint64_t at(int x, int y) const {
        const TileCell terrain = terrain_ == nullptr ? 0 : terrain_->at(x, y);
        return terrain != 0 ? std::uint64_t{terrain} << 32 : grid_.at(x, y);
    }

private:
    const TileGrid& grid_;
    const TileGrid* terrain_;
};

/// A sparse set of cells: memory is allocated only for chunks with marked cells.
class CellMarks {
public:
    explicit CellMarks(const TileGrid& grid)
        : columns_{grid.chunkColumns()},
          chunks_(static_cast<std::size_t>(grid.chunkColumns()) *
                  static_cast<std::size_t>(grid.chunkRows())) {}

    /// Marks a cell. @return false if it was already marked
    bool mark(int x, int y) {
        constexpr int kSide = TileGrid::kChunkSide;
        auto& chunk = chunks_[static_cast<std::size_t>(y / kSide) * static_cast<std::size_t>(columns_) +
                              static_cast<std::size_t>(x / kSide)];
        if (chunk == nullptr) chunk = std::make_unique<Bits>();
        const std::size_t slot = TileGrid::Chunk::slot(x, y);
        if (chunk->test(slot)) return false;
        chunk->set(slot);
        return true;
    }

private:
    using Bits = std::bitset<std::size_t{TileGrid::kChunkSide} * TileGrid::kChunkSide>;
    int columns_;
    std::vector<std::unique_ptr<Bits>> chunks_;
};

}  // namespace

std::vector<CellPlace> lineOfCells(CellPlace from, CellPlace to) {
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    std::vector<CellPlace> cells{from};
    for (int i = 1; i <= steps; ++i) {
        const auto between = [&](int a, int b) {
            return static_cast<int>(a + (std::int64_t{b} - a) * i / steps);
        };
        cells.push_back({between(from.x, to.x), between(from.y, to.y)});
    }
    return cells;
}

std::vector<CellPlace> boxOfCells(const TileGrid& grid, CellPlace a, CellPlace b) {
    std::vector<CellPlace> cells;
    for (int y = std::max(std::min(a.y, b.y), 0); y <= std::min(std::max(a.y, b.y), grid.height() - 1); ++y) {
        for (int x = std::max(std::min(a.x, b.x), 0); x <= std::min(std::max(a.x, b.x), grid.width() - 1);
             ++x)
            cells.push_back({x, y});
    }
    return cells;
}

std::vector<CellPlace> ellipseOfCells(const TileGrid& grid, CellPlace a, CellPlace b) {
    std::vector<CellPlace> cells = boxOfCells(grid, a, b);
    // Computed in half cells, so that the center is an integer and the result is the same on every platform.
    const std::int64_t width = std::abs(a.x - b.x) + 1;
    const std::int64_t height = std::abs(a.y - b.y) + 1;
    std::erase_if(cells, [&](CellPlace place) {
        const std::int64_t x = 2 * std::int64_t{place.x} - a.x - b.x;
        const std::int64_t y = 2 * std::int64_t{place.y} - a.y - b.y;
        return x * x * height * height + y * y * width * width > width * width * height * height;
    });
    return cells;
}

CellPlace squareCorner(CellPlace from, CellPlace to) {
    const int side = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    return {from.x + (to.x < from.x ? -side : side), from.y + (to.y < from.y ? -side : side)};
}

std::vector<CellPlace> connectedCells(const TileGrid& grid, const TileGrid* terrain, CellPlace from,
                                      std::size_t most) {
    std::vector<CellPlace> filled;
    if (!grid.has(from.x, from.y)) return filled;
    const CellKeys keys{grid, terrain};
    const std::uint64_t wanted = keys.at(from.x, from.y);
    CellMarks seen{grid};
    const auto visit = [&](int x, int y) {
        if (grid.has(x, y) && keys.at(x, y) == wanted && seen.mark(x, y)) filled.push_back({x, y});
    };
    visit(from.x, from.y);
    for (std::size_t i = 0; i < filled.size() && filled.size() < most; ++i) {
        const CellPlace at = filled[i];
        visit(at.x - 1, at.y);
        visit(at.x + 1, at.y);
        visit(at.x, at.y - 1);
        visit(at.x, at.y + 1);
    }
    return filled;
}

std::vector<CellPlace> equalCells(const TileGrid& grid, const TileGrid* terrain, CellPlace to) {
    std::vector<CellPlace> equal;
    if (!grid.has(to.x, to.y)) return equal;
    constexpr int kSide = TileGrid::kChunkSide;
    const CellKeys keys{grid, terrain};
    const std::uint64_t wanted = keys.at(to.x, to.y);
    for (int y = 0; y < grid.height() && equal.size() < kMostFilled; ++y) {
        for (int x = 0; x < grid.width(); ++x) {
            if (wanted != 0 && terrain == nullptr && grid.chunk(x / kSide, y / kSide) == nullptr) {
                x |= kSide - 1;
            } else if (keys.at(x, y) == wanted) {
                equal.push_back({x, y});
            }
        }
    }
    return equal;
}

std::vector<CellPlace> equalCellsNear(const TileGrid& grid, const TileGrid* terrain, CellPlace to,
                                      int columns, int rows) {
    if (!grid.has(to.x, to.y)) return {};
    const CellKeys keys{grid, terrain};
    std::vector<CellPlace> cells =
        boxOfCells(grid, {to.x - columns, to.y - rows}, {to.x + columns, to.y + rows});
    std::erase_if(cells, [&](CellPlace place) { return keys.at(place.x, place.y) != keys.at(to.x, to.y); });
    return cells;
}

}  // namespace plumb::editor
