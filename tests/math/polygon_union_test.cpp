#include "math/polygon_union.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

using Polygon = std::vector<GridPoint>;
using Polygons = std::vector<Polygon>;
using Edges = std::vector<GridEdge>;

struct Point {
    double x = 0.0;
    double y = 0.0;
};

Polygon box(std::int32_t left, std::int32_t top, std::int32_t right, std::int32_t bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

/// How often the edges go around a point: +1 for each turn with the area on the right (y down).
int turnsAround(const Edges& edges, Point p) {
    int turns = 0;
    for (const auto& [a, b] : edges) {
        const bool goesDown = a.y <= p.y && b.y > p.y, goesUp = b.y <= p.y && a.y > p.y;
        if (!goesDown && !goesUp) continue;
        const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x > p.x) turns += goesDown ? 1 : -1;
    }
    return turns;
}

bool isInside(const Polygon& polygon, Point p) {
    bool isOdd = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const GridPoint a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if ((a.y <= p.y) != (b.y <= p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x)
            isOdd = !isOdd;
    }
    return isOdd;
}

double distanceToEdge(const GridEdge& edge, Point p) {
    const double x = edge.b.x - edge.a.x, y = edge.b.y - edge.a.y, square = x * x + y * y;
    const double px = p.x - edge.a.x, py = p.y - edge.a.y;
    const double t = square > 0.0 ? std::clamp((px * x + py * y) / square, 0.0, 1.0) : 0.0;
    return std::hypot(px - t * x, py - t * y);
}

double distanceToEdges(const Polygons& polygons, Point p) {
    double least = 1e9;
    for (const Polygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.size(); ++i)
            least = std::min(least, distanceToEdge({polygon[i], polygon[(i + 1) % polygon.size()]}, p));
    }
    return least;
}

/// True if two edges have a point in common that is not an end of both.
bool doMeet(const GridEdge& one, const GridEdge& two) {
    const auto side = [](const GridEdge& edge, GridPoint p) {
        const std::int64_t turn = cross(edge.b - edge.a, p - edge.a);
        return (turn > 0) - (turn < 0);
    };
    const auto isWithin = [&](const GridEdge& edge, GridPoint p) {
        return side(edge, p) == 0 && p != edge.a && p != edge.b && dot(p - edge.a, p - edge.b) < 0;
    };
    for (const GridPoint end : {two.a, two.b}) {
        if (isWithin(one, end)) return true;
    }
    for (const GridPoint end : {one.a, one.b}) {
        if (isWithin(two, end)) return true;
    }
    return side(one, two.a) * side(one, two.b) < 0 && side(two, one.a) * side(two, one.b) < 0;
}

/// Checks what holds for the edges of any area.
void expectOutlines(const Edges& edges) {
    std::map<std::pair<int, int>, int> leaving;  // edges from a point, less those to it
    for (std::size_t i = 0; i < edges.size(); ++i) {
        ASSERT_NE(edges[i].a, edges[i].b);
        ++leaving[{edges[i].a.x, edges[i].a.y}];
        --leaving[{edges[i].b.x, edges[i].b.y}];
        for (std::size_t k = 0; k < i; ++k) {
            ASSERT_FALSE(doMeet(edges[i], edges[k]));
            ASSERT_FALSE(edges[i] == edges[k] || edges[i] == (GridEdge{edges[k].b, edges[k].a}));
        }
    }
    for (const auto& [point, count] : leaving) ASSERT_EQ(count, 0) << point.first << " " << point.second;
    Edges sorted = edges;
    sortEdges(sorted);
    EXPECT_EQ(sorted, edges);
}

Polygons randomPolygons(Random& random, std::int32_t size) {
    Polygons polygons(1 + random.below(5));
    for (Polygon& polygon : polygons) {
        for (std::uint32_t corners = 3 + random.below(4); corners > 0; --corners) {
            const auto coordinate = [&] { return static_cast<std::int32_t>(random.below(2 * size)) - size; };
            const std::int32_t x = coordinate();
            polygon.push_back({x, coordinate()});
        }
    }
    return polygons;
}

TEST(PolygonUnionProperty, containsThePointsThatAreInAnyPolygon) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Polygons polygons = randomPolygons(random, 1000);
        const auto edges = boundaryOf(polygons);
        ASSERT_TRUE(edges.has_value());
        expectOutlines(*edges);
        for (int i = 0; i < 100; ++i) {
            const Point p{random.between(-1100.0f, 1100.0f), random.between(-1100.0f, 1100.0f)};
            if (distanceToEdges(polygons, p) < 3.0) continue;  // crossings are rounded
            const bool isIn = std::any_of(polygons.begin(), polygons.end(),
                                          [&](const Polygon& polygon) { return isInside(polygon, p); });
            ASSERT_EQ(turnsAround(*edges, p), isIn ? 1 : 0) << p.x << " " << p.y;
        }
    }
}

TEST(PolygonUnionProperty, dependsOnlyOnTheAreaOfThePolygons) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const std::int32_t size = random.below(2) == 0 ? 6 : 200;  // many points in common, or few
        const Polygons polygons = randomPolygons(random, size);
        const auto edges = boundaryOf(polygons);
        ASSERT_TRUE(edges.has_value());
        expectOutlines(*edges);
        Polygons same{polygons.rbegin(), polygons.rend()};
        for (Polygon& polygon : same) {
            std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
            if (random.below(2) == 0) std::reverse(polygon.begin(), polygon.end());
        }
        same.push_back(same.front());
        same.push_back({{3, 3}, {3, 3}, {3, 3}});  // no area
        EXPECT_EQ(boundaryOf(same), edges);
    }
}

TEST(PolygonUnionProperty, movesWithThePolygons) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Random random = Random::seeded(seed);
        Polygons polygons = randomPolygons(random, 20);
        auto edges = boundaryOf(polygons);
        ASSERT_TRUE(edges.has_value());
        const GridPoint by{static_cast<std::int32_t>(random.below(99)) - 50, 17};
        for (Polygon& polygon : polygons) {
            for (GridPoint& corner : polygon) corner = corner + by;
        }
        for (GridEdge& edge : *edges) edge = {edge.a + by, edge.b + by};
        EXPECT_EQ(boundaryOf(polygons), edges) << seed << ": halves are rounded up on both sides of zero";
    }
}

/// The outline of cells of a grid, from its definition: the sides between a cell and none, joined where one
/// continues the other and no other begins.
Edges outlineOf(const std::vector<std::vector<bool>>& cells) {
    const auto has = [&](std::int32_t x, std::int32_t y) {
        return y >= 0 && x >= 0 && y < std::ssize(cells) && x < std::ssize(cells[0]) &&
               cells[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
    };
    Edges edges;
    const auto add = [&](GridPoint a, GridPoint b) { edges.push_back({a, b}); };
    for (std::int32_t y = 0; y < std::ssize(cells); ++y) {
        for (std::int32_t x = 0; x < std::ssize(cells[0]); ++x) {
            if (!has(x, y)) continue;
            if (!has(x, y - 1)) add({x, y}, {x + 1, y});
            if (!has(x + 1, y)) add({x + 1, y}, {x + 1, y + 1});
            if (!has(x, y + 1)) add({x + 1, y + 1}, {x, y + 1});
            if (!has(x - 1, y)) add({x, y + 1}, {x, y});
        }
    }
    for (bool any = true; any;) {
        any = false;
        for (std::size_t i = 0; i < edges.size() && !any; ++i) {
            std::vector<std::size_t> next;
            for (std::size_t k = 0; k < edges.size(); ++k) {
                if (edges[k].a == edges[i].b) next.push_back(k);
            }
            if (next.size() != 1 || cross(edges[i].b - edges[i].a, edges[next[0]].b - edges[next[0]].a) != 0)
                continue;
            edges[i].b = edges[next[0]].b;
            edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(next[0]));
            any = true;
        }
    }
    sortEdges(edges);
    return edges;
}

TEST(PolygonUnionProperty, isTheOutlineOfCellsHoweverTheyAreJoinedToBoxes) {
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        std::vector<std::vector<bool>> cells(5, std::vector<bool>(6));
        Polygons squares, rows, columns;
        for (auto& row : cells) {
            for (std::size_t x = 0; x < row.size(); ++x) row[x] = random.below(3) != 0;
        }
        for (std::int32_t y = 0; y < 5; ++y) {
            for (std::int32_t x = 0; x < 6; ++x) {
                if (!cells[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]) continue;
                squares.push_back(box(x, y, x + 1, y + 1));
                std::int32_t right = x + 1, bottom = y + 1;
                while (right < 6 && cells[static_cast<std::size_t>(y)][static_cast<std::size_t>(right)])
                    ++right;
                while (bottom < 5 && cells[static_cast<std::size_t>(bottom)][static_cast<std::size_t>(x)])
                    ++bottom;
                rows.push_back(box(x, y, right, y + 1));  // they overlap
                columns.push_back(box(x, y, x + 1, bottom));
            }
        }
        const Edges expected = outlineOf(cells);
        EXPECT_EQ(boundaryOf(squares), expected);
        EXPECT_EQ(boundaryOf(rows), expected);
        EXPECT_EQ(boundaryOf(columns), expected);
    }
}

TEST(PolygonUnion, crossingsAreRoundedHalvesUp) {
    for (const std::int32_t at : {-7, -1, 0, 5}) {
        // Two triangles whose longest sides cross at (at + 0.5, at + 0.5), where the outline has a corner.
        const auto edges = boundaryOf(Polygons{{{at - 1, at - 1}, {at + 2, at + 2}, {at - 1, at + 9}},
                                               {{at + 2, at - 1}, {at - 1, at + 2}, {at + 9, at - 1}}});
        ASSERT_TRUE(edges.has_value());
        expectOutlines(*edges);
        const auto beginsAt = [&](GridPoint point) {
            return std::any_of(edges->begin(), edges->end(),
                               [&](const GridEdge& edge) { return edge.a == point; });
        };
        EXPECT_TRUE(beginsAt({at + 1, at + 1})) << at;
        EXPECT_FALSE(beginsAt({at, at})) << at;
    }
}

TEST(PolygonUnion, aPolygonWithAHoleOrACrossingIsInsideWhereARayCrossesItOddly) {
    const auto star = boundaryOf(Polygons{{{0, 0}, {10, 0}, {0, 10}, {10, 10}}});  // an hourglass
    ASSERT_TRUE(star.has_value());
    EXPECT_EQ(star->size(), 6u);
    EXPECT_EQ(turnsAround(*star, {5.0, 2.0}), 1);
    EXPECT_EQ(turnsAround(*star, {5.0, 8.0}), 1);
    EXPECT_EQ(turnsAround(*star, {2.0, 5.1}), 0);
    EXPECT_EQ(mostFromOnePoint(*star), 2);
    EXPECT_TRUE(ringOf(*star).empty()) << "two outlines that touch";
}

TEST(PolygonUnion, nothingHasNoEdges) {
    EXPECT_EQ(boundaryOf({}), Edges{});
    EXPECT_EQ(boundaryOf(Polygons{{}, {{1, 1}}, {{1, 1}, {4, 1}}, {{0, 0}, {3, 3}, {6, 6}}}), Edges{});
    EXPECT_EQ(mostFromOnePoint({}), 0);
    EXPECT_TRUE(ringOf({}).empty());
}

TEST(PolygonUnion, morePartsThanTheLimitAreRefused) {
    Polygon comb;  // 8193 edges: one more than the limit
    for (std::int32_t i = 0; i < 8192; ++i) comb.push_back({i, i % 2});
    comb.push_back({4000, 100});
    EXPECT_FALSE(boundaryOf(Polygons{comb}).has_value());
}

TEST(PolygonUnion, edgesAreSortedByTheirStartsRowByRowAndThenByTheirEnds) {
    const Edges expected{
        {{5, 0}, {0, 0}}, {{0, 1}, {3, 1}}, {{0, 1}, {1, 2}}, {{2, 1}, {0, 0}}, {{-9, 4}, {0, 0}}};
    Edges edges{expected[3], expected[0], expected[4], expected[2], expected[1]};
    sortEdges(edges);
    EXPECT_EQ(edges, expected);
}

TEST(PolygonUnion, theRingOfASingleOutlineHasItsCornersInOrder) {
    const auto edges = boundaryOf(Polygons{box(0, 0, 4, 3)});
    ASSERT_TRUE(edges.has_value());
    EXPECT_EQ(ringOf(*edges), (Polygon{{0, 0}, {4, 0}, {4, 3}, {0, 3}})) << "clockwise on screen";
    EXPECT_EQ(mostFromOnePoint(*edges), 1);
    const auto touching = boundaryOf(Polygons{box(0, 0, 4, 3), box(4, 3, 6, 6)});
    EXPECT_EQ(mostFromOnePoint(*touching), 2);
    EXPECT_TRUE(ringOf(*touching).empty()) << "two boxes with a common corner";
    EXPECT_TRUE(ringOf(*boundaryOf(Polygons{box(0, 0, 4, 3), box(7, 0, 9, 3)})).empty()) << "two outlines";
    EXPECT_TRUE(ringOf(*boundaryOf(Polygons{
                           {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}}}))
                    .empty())
        << "a hole";
    EXPECT_TRUE(ringOf(Edges{{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}}).empty()) << "open";
    EXPECT_TRUE(ringOf(Edges{{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {1, 0}}}).empty())
        << "it does not come back to its start";
}

}  // namespace
}  // namespace plumb
