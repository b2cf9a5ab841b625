// Positions of tiles in isometric, staggered and hexagonal maps, against the formulas of the format.

#include "import/map_lattice.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

using tiled::Orientation;

/// Lower left corner of the tile in a cell, px, as the format defines it. Sizes in px.
struct Corner {
    int left = 0;
    int bottom = 0;

    friend auto operator<=>(const Corner&, const Corner&) = default;
};

bool isOdd(int number) { return number % 2 != 0; }

Corner cornerOf(const tiled::Map& map, int x, int y) {
    const int width = map.tileWidth;
    const int height = map.tileHeight;
    if (map.orientation == Orientation::Orthogonal) return {x * width, (y + 1) * height};
    if (map.orientation == Orientation::Isometric) {
        const int originX = map.height * width / 2;  // screen x of the upper corner of cell (0, 0)
        return {originX + (x - y) * width / 2 - width / 2, (x + y) * height / 2 + height};
    }
    const int side = map.orientation == Orientation::Hexagonal ? map.hexSide : 0;
    if (map.staggersX) {
        const bool shifted = isOdd(x) != map.staggersEven;
        return {x * (width + side) / 2, y * height + (shifted ? height / 2 : 0) + height};
    }
    const bool shifted = isOdd(y) != map.staggersEven;
    return {x * width + (shifted ? width / 2 : 0), y * (height + side) / 2 + height};
}

/// Maps of all orientations, stagger axes and indices with random sizes. Half tiles and halves of the rest
/// beside the side of a hexagon are whole px.
template <class Visit>
void eachMap(Visit visit) {
    Random random = Random::seeded(11);
    for (int i = 0; i < 400; ++i) {
        tiled::Map map;
        map.orientation = static_cast<Orientation>(i % 4);
        map.staggersX = i / 4 % 2 == 0;
        map.staggersEven = i / 8 % 2 == 0;
        map.tileWidth = 2 + 2 * static_cast<int>(random.below(40));
        map.tileHeight = 2 + 2 * static_cast<int>(random.below(40));
        const int along = map.staggersX ? map.tileWidth : map.tileHeight;
        map.hexSide = 2 * static_cast<int>(random.below(static_cast<std::uint32_t>(along / 2)));
        map.width = 1 + static_cast<int>(random.below(9));
        map.height = 1 + static_cast<int>(random.below(9));
        SCOPED_TRACE(format("{} {} x {} px, side {}, {} {}", tiled::nameOf(map.orientation), map.tileWidth,
                            map.tileHeight, map.hexSide, map.staggersX ? "x" : "y",
                            map.staggersEven ? "even" : "odd"));
        visit(map);
    }
}

Corner cornerIn(const MapLattice& lattice, MapLattice::Cell cell) {
    return {cell.column * lattice.cellWidth(), (cell.row + 1) * lattice.cellHeight() + lattice.drop()};
}

TEST(MapLatticeTest, tilesStandWhereTheFormatSays) {
    eachMap([](const tiled::Map& map) {
        const MapLattice lattice{map};
        for (int y = -6; y < 7; ++y) {
            for (int x = -6; x < 7; ++x)
                ASSERT_EQ(cornerIn(lattice, lattice.cellOf(x, y)), cornerOf(map, x, y)) << x << " " << y;
        }
    });
}

TEST(MapLatticeTest, everyCellHasItsOwnAndLiesInTheAreaOfItsRectangle) {
    eachMap([](const tiled::Map& map) {
        const MapLattice lattice{map};
        const MapLattice::Area area = lattice.areaOf(-3, -2, map.width, map.height);
        std::set<std::pair<int, int>> taken;
        for (int y = -2; y < map.height - 2; ++y) {
            for (int x = -3; x < map.width - 3; ++x) {
                const MapLattice::Cell cell = lattice.cellOf(x, y);
                EXPECT_TRUE(taken.insert({cell.row, cell.column}).second) << x << " " << y;
                EXPECT_GE(cell.column, area.first.column);
                EXPECT_GE(cell.row, area.first.row);
                EXPECT_LT(cell.column, area.first.column + area.width);
                EXPECT_LT(cell.row, area.first.row + area.height);
            }
        }
    });
}

TEST(MapLatticeTest, theBoxOfTheMapIsThatAroundItsTiles) {
    eachMap([](tiled::Map map) {
        map.width = std::max(map.width, 2);  // a single column or row may be the shifted one
        map.height = std::max(map.height, 2);
        Corner first = cornerOf(map, 0, 0);
        Corner last = first;
        for (int y = 0; y < map.height; ++y) {
            for (int x = 0; x < map.width; ++x) {
                const Corner corner = cornerOf(map, x, y);
                first = {std::min(first.left, corner.left), std::min(first.bottom, corner.bottom)};
                last = {std::max(last.left, corner.left), std::max(last.bottom, corner.bottom)};
            }
        }
        const Rect box = boundsOf(map);
        EXPECT_EQ(box.x, static_cast<float>(first.left));
        EXPECT_EQ(box.y, static_cast<float>(first.bottom - map.tileHeight));
        EXPECT_EQ(box.width, static_cast<float>(last.left + map.tileWidth - first.left));
        EXPECT_EQ(box.height, static_cast<float>(last.bottom - first.bottom + map.tileHeight));
    });
}

TEST(MapLatticeTest, theBoxOfAnInfiniteMapIsThatAroundItsLayers) {
    tiled::Map map;
    map.orientation = Orientation::Staggered;
    map.infinite = true;
    map.tileWidth = 64;
    map.tileHeight = 32;
    EXPECT_TRUE(boundsOf(map).empty());
    for (const int x : {-16, 16}) {
        tiled::Layer layer;
        layer.x = x;
        layer.y = -2;
        layer.width = 16;
        layer.height = 4;
        layer.cells.assign(64, 0);
        map.layers.push_back(layer);
    }
    EXPECT_EQ(boundsOf(map), (Rect{-1024.0f, -32.0f, 48.0f * 64.0f + 32.0f, 80.0f}));
}

TEST(MapLatticeTest, sizesThatNoMapShouldHaveStillGiveCells) {
    for (const Orientation orientation :
         {Orientation::Isometric, Orientation::Staggered, Orientation::Hexagonal}) {
        for (const int side : {0, 1, 16384}) {
            for (const bool alongX : {false, true}) {
                tiled::Map map;
                map.orientation = orientation;
                map.staggersX = alongX;
                map.hexSide = side;
                map.tileWidth = map.tileHeight = 1;
                EXPECT_GE(MapLattice{map}.cellWidth(), 1);
                EXPECT_GE(MapLattice{map}.cellHeight(), 1);
            }
        }
    }
}

}  // namespace
}  // namespace plumb
