#include "import/ldtk_stacks.hpp"

#include <algorithm>
#include <map>

namespace plumb {
namespace {

constexpr int kLoose = -1;
constexpr std::size_t kCrowded = 1024;  // maximum number of tiles stored in a Square, to limit comparisons

/// A tile that has been assigned to a level of the stack.
struct Laid {
    int x = 0;  ///< px
    int y = 0;
    int level = 0;
    int cell = kLoose;  ///< index of its cell; kLoose if it is off the grid
};

/// A square of tile size, so that no tile overlaps more than four squares.
struct Square {
    std::vector<Laid> tiles;
    int highest = 0;  ///< highest level of all tiles that overlap the square
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
    /// Returns the index of a tile's cell; kLoose if the tile is off the grid or translucent.
    [[nodiscard]] int cellOf(const ldtk::Tile& tile) const {
        const bool fits = tile.opacity == 1.0f && tile.x >= 0 && tile.y >= 0 && tile.x % layer_.grid == 0 &&
                          tile.y % layer_.grid == 0 && tile.tile < tileCount_;
        const int x = tile.x / layer_.grid;
        const int y = tile.y / layer_.grid;
        return fits && x < layer_.columns && y < layer_.rows ? y * layer_.columns + x : kLoose;
    }

    [[nodiscard]] bool overlap(const Laid& a, const Laid& b) const {
        return std::abs(a.x - b.x) < tileSize_ && std::abs(a.y - b.y) < tileSize_;
    }

    /// Returns the lowest level for a tile that must be drawn above `below`. It is the level of `below` if
    /// both are on the grid and the tile's cell is later, because grids are drawn cell by cell, row by row.
    static int levelAbove(const Laid& below, int cell) {
        const bool sameGrid = cell != kLoose && below.cell != kLoose && below.cell < cell;
        return sameGrid ? below.level : below.level + 1;
    }

    [[nodiscard]] int levelAt(const Square& square, const Laid& tile) const {
        if (square.tiles.size() >= kCrowded) return square.highest + 1;
        int level = 0;
        for (const Laid& below : square.tiles) {
            if (overlap(below, tile)) level = std::max(level, levelAbove(below, tile.cell));
        }
        return level;
    }

    void lay(const ldtk::Tile& tile) {
        Laid laid{tile.x, tile.y, 0, cellOf(tile)};
        const int left = floorDiv(tile.x, tileSize_);
        const int top = floorDiv(tile.y, tileSize_);
        const int right = floorDiv(tile.x + tileSize_ - 1, tileSize_);
        const int bottom = floorDiv(tile.y + tileSize_ - 1, tileSize_);
        const auto eachSquare = [&](auto&& visit) {
            for (int y = top; y <= bottom; ++y) {
                for (int x = left; x <= right; ++x) visit(squares_[{x, y}]);
            }
        };
        eachSquare([&](const Square& square) { laid.level = std::max(laid.level, levelAt(square, laid)); });
        if (laid.level >= kMaxStackedTiles) {
            laid.level = kMaxStackedTiles - 1;
            laid.cell = kLoose;
        }
        eachSquare([&](Square& square) {
            square.highest = std::max(square.highest, laid.level);
            if (square.tiles.size() < kCrowded) square.tiles.push_back(laid);
        });
        put(tile, laid);
    }

    void put(const ldtk::Tile& tile, const Laid& laid) {
        const auto level = static_cast<std::size_t>(laid.level);
        if (result_.levels.size() <= level) result_.levels.resize(level + 1);
        LdtkStacks::Level& target = result_.levels[level];
        if (laid.cell == kLoose) {
            target.loose.push_back(&tile);
            return;
        }
        if (target.count == 0) target.cells = TileGrid{layer_.columns, layer_.rows};
        const TileCell flips =
            ((tile.flips & 1u) != 0 ? kTileFlipX : 0u) | ((tile.flips & 2u) != 0 ? kTileFlipY : 0u);
        target.cells.set(laid.cell % layer_.columns, laid.cell / layer_.columns,
                         plumb::cellOf(tile.tile, flips));
        ++target.count;
    }

    const ldtk::Layer& layer_;
    int tileSize_;
    int tileCount_;
    LdtkStacks result_;
    std::map<std::pair<int, int>, Square> squares_;
};

}  // namespace

LdtkStacks stackTiles(const ldtk::Layer& layer, int tileSize, int tileCount) {
    return Stacker{layer, tileSize, tileCount}.stack();
}

}  // namespace plumb
