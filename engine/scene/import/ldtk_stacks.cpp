#include "scene/import/ldtk_stacks.hpp"

#include <algorithm>
#include <map>

namespace plumb {
namespace {

constexpr int kLoose = -1;

/// A tile that lies over some cell.
struct Laid {
    int level = 0;
    int cell = kLoose;  ///< its own, when it fits the grid
};

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

class Stacker {
public:
    Stacker(const ldtk::Layer& layer, int tileSize, int tileCount)
        : layer_{layer}, tileSize_{std::max(tileSize, 1)}, tileCount_{tileCount} {}

    LdtkStacks stack() {
        for (const ldtk::Tile& tile : layer_.tiles) lay(tile);
        return std::move(result_);
    }

private:
    /// The cell that a tile fills as cells are filled, or none.
    [[nodiscard]] int cellOf(const ldtk::Tile& tile) const {
        const bool fits = tile.opacity == 1.0f && tile.x >= 0 && tile.y >= 0 && tile.x % layer_.grid == 0 &&
                          tile.y % layer_.grid == 0 && tile.tile < tileCount_;
        const int x = tile.x / layer_.grid;
        const int y = tile.y / layer_.grid;
        return fits && x < layer_.columns && y < layer_.rows ? y * layer_.columns + x : kLoose;
    }

    /// Grids are drawn row by row, so of two tiles that lie over each other in one of them the later cell is
    /// above. What the file has above must stay above.
    static int levelAbove(const Laid& below, int cell) {
        const bool sameGrid = cell != kLoose && below.cell != kLoose && below.cell < cell;
        return sameGrid ? below.level : below.level + 1;
    }

    void lay(const ldtk::Tile& tile) {
        const int cell = cellOf(tile);
        const int left = floorDiv(tile.x, layer_.grid);
        const int top = floorDiv(tile.y, layer_.grid);
        const int right = floorDiv(tile.x + tileSize_ - 1, layer_.grid);
        const int bottom = floorDiv(tile.y + tileSize_ - 1, layer_.grid);
        int level = 0;
        const auto eachCell = [&](auto&& visit) {
            for (int y = top; y <= bottom; ++y) {
                for (int x = left; x <= right; ++x) visit(laid_[(static_cast<std::int64_t>(y) << 32) + x]);
            }
        };
        eachCell([&](const std::vector<Laid>& here) {
            for (const Laid& below : here) level = std::max(level, levelAbove(below, cell));
        });
        eachCell([&](std::vector<Laid>& here) { here.push_back({level, cell}); });
        put(tile, cell, static_cast<std::size_t>(level));
    }

    void put(const ldtk::Tile& tile, int cell, std::size_t level) {
        if (result_.levels.size() <= level) result_.levels.resize(level + 1);
        LdtkStacks::Level& target = result_.levels[level];
        if (cell == kLoose) {
            target.loose.push_back(&tile);
            return;
        }
        if (target.cells.empty()) {
            target.cells.resize(static_cast<std::size_t>(layer_.columns) *
                                static_cast<std::size_t>(layer_.rows));
        }
        const TileCell flips =
            ((tile.flips & 1u) != 0 ? kTileFlipX : 0u) | ((tile.flips & 2u) != 0 ? kTileFlipY : 0u);
        target.cells[static_cast<std::size_t>(cell)] = plumb::cellOf(tile.tile, flips);
        ++target.count;
    }

    const ldtk::Layer& layer_;
    int tileSize_;
    int tileCount_;
    LdtkStacks result_;
    std::map<std::int64_t, std::vector<Laid>> laid_;  // by cell
};

}  // namespace

LdtkStacks stackTiles(const ldtk::Layer& layer, int tileSize, int tileCount) {
    return Stacker{layer, tileSize, tileCount}.stack();
}

}  // namespace plumb
