// Tile forms that are the union of polygons: concave ones, several ones, with holes.

#include "physics/terrain/tile_mask.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "math/portable.hpp"
#include "tests/physics/support/random_terrain.hpp"

namespace plumb::physics {
namespace {

using namespace test;
using Polygon = std::vector<Vec2>;
using Polygons = std::vector<Polygon>;

constexpr std::int64_t kWhole = 2 * std::int64_t{kCellUnits} * kCellUnits;

/// True if a ray from a point leaves a polygon: it crosses the sides an odd number of times.
bool isInside(const Polygon& polygon, Vec2 point) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if ((a.y <= point.y) == (b.y <= point.y)) continue;
        if (a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y) > point.x) inside = !inside;
    }
    return inside;
}

float distanceTo(const Polygon& polygon, Vec2 point) {
    float least = 1e9f;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a;
        const float square = lengthSquared(along);
        const float part = square > 0.0f ? std::clamp(dot(point - a, along) / square, 0.0f, 1.0f) : 0.0f;
        least = std::min(least, length(point - a - along * part));
    }
    return least;
}

/// How often closed edges go around a point, clockwise on screen.
template <class Edges>
int turnsAround(const Edges& edges, Vec2 point) {
    int turns = 0;
    for (const auto& edge : edges) {
        const Vec2 a = toMetres(edge.a, {1.0f, 1.0f}), b = toMetres(edge.b, {1.0f, 1.0f});
        if ((a.y <= point.y) == (b.y <= point.y)) continue;
        if (a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y) > point.x) turns += b.y > a.y ? 1 : -1;
    }
    return turns;
}

Vec2 flippedPart(Vec2 point, TileCell flips) {
    if ((flips & kTileFlipDiagonal) != 0) std::swap(point.x, point.y);
    if ((flips & kTileFlipX) != 0) point.x = 1.0f - point.x;
    if ((flips & kTileFlipY) != 0) point.y = 1.0f - point.y;
    return point;
}

Polygon randomStar(Random& random) {
    const Vec2 center{random.between(0.3f, 0.7f), random.between(0.3f, 0.7f)};
    const std::uint32_t count = 3 + random.below(12);
    const float turn = random.between(0.0f, kTau);
    Polygon star;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float angle = turn + kTau * static_cast<float>(i) / static_cast<float>(count);
        star.push_back(center + Vec2{cosine(angle), sine(angle)} * random.between(0.05f, 0.29f));
    }
    if (random.below(2) == 0) std::reverse(star.begin(), star.end());
    return star;
}

Polygon randomEllipse(Random& random) {
    const Vec2 center{random.between(0.3f, 0.7f), random.between(0.3f, 0.7f)};
    const Vec2 radius{random.between(0.05f, 0.29f), random.between(0.05f, 0.29f)};
    Polygon ellipse;
    for (int i = 0; i < 24; ++i) {
        const float angle = kTau * static_cast<float>(i) / 24.0f;
        ellipse.push_back(center + scaled(Vec2{cosine(angle), sine(angle)}, radius));
    }
    return ellipse;
}

/// Corners anywhere: the sides cross each other.
Polygon randomTangle(Random& random) {
    Polygon tangle;
    for (std::uint32_t i = 4 + random.below(5); i > 0; --i) tangle.push_back({random.unit(), random.unit()});
    return tangle;
}

Polygons randomPolygons(Random& random) {
    Polygons polygons;
    for (std::uint32_t i = 1 + random.below(4); i > 0; --i) {
        const std::uint32_t kind = random.below(8);
        polygons.push_back(kind == 0  ? randomTangle(random)
                           : kind < 4 ? randomEllipse(random)
                                      : randomStar(random));
    }
    return polygons;
}

/// Expects that the form is solid exactly where one of the polygons is, except near their sides.
void expectEqualAreas(const TileOutline& outline, const Polygons& polygons, TileCell flips, Random& random) {
    for (int i = 0; i < 200; ++i) {
        const Vec2 point{random.unit(), random.unit()};
        const auto isNear = [&](const Polygon& polygon) { return distanceTo(polygon, point) < 0.006f; };
        if (std::any_of(polygons.begin(), polygons.end(), isNear)) continue;
        const bool solid = std::any_of(polygons.begin(), polygons.end(),
                                       [&](const Polygon& polygon) { return isInside(polygon, point); });
        ASSERT_EQ(turnsAround(outline.edges, flippedPart(point, flips)), solid ? 1 : 0)
            << point.x << ' ' << point.y;
    }
}

TEST(TileArea, isSolidWhereOneOfItsPolygonsIs) {
    Random random = Random::seeded(11);
    int accepted = 0;
    for (int seed = 0; seed < masksToTry(400); ++seed) {
        SCOPED_TRACE(seed);
        const Polygons polygons = randomPolygons(random);
        TilePalette palette;
        const auto form = palette.addPolygons(polygons);
        if (!form) continue;
        ++accepted;
        for (TileCell turn = 0; turn < 8; ++turn) {
            const TileCell flips = turn << 29;
            ASSERT_EQ(flips & ~kTileFlips, 0u);
            const auto flipped = palette.flipped(*form, flips);
            ASSERT_TRUE(flipped.ok());
            expectEqualAreas(palette.outline(*flipped), polygons, flips, random);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(accepted, masksToTry(400) * 95 / 100);
}

TEST(TileArea, equalAreasAreOneForm) {
    TilePalette palette;
    const Polygon left{{0, 0}, {0.5f, 0}, {0.5f, 1}, {0, 1}};
    const Polygon right{{1, 1}, {1, 0}, {0.25f, 0}, {0.25f, 1}};
    EXPECT_EQ(*palette.addPolygons(Polygons{left, right}), TileForm::Full);
    EXPECT_EQ(*palette.addPolygons(Polygons{left}), TileForm::HalfLeft);
    EXPECT_EQ(*palette.addPolygons(Polygons{left, left}), TileForm::HalfLeft);
    const Polygon corner{{0, 0}, {1, 0}, {1, 0.5f}, {0.5f, 0.5f}, {0.5f, 1}, {0, 1}};
    const Polygon top{{0, 0}, {1, 0}, {1, 0.5f}, {0, 0.5f}};
    const TileForm bend = *palette.addPolygons(Polygons{corner});
    EXPECT_EQ(*palette.addPolygons(Polygons{top, left}), bend);
    EXPECT_EQ(*palette.flipped(bend, kTileFlipDiagonal), bend);
    EXPECT_EQ(*palette.flipped(*palette.flipped(bend, kTileFlipX), kTileFlipX), bend);
    EXPECT_EQ(doubleAreaOf(palette.outline(bend)), kWhole * 3 / 4);
}

TEST(TileArea, refusesWhatHasNoAreaOrLeavesTheCell) {
    TilePalette palette;
    const Polygon line{{0, 0}, {1, 1}, {0.5f, 0.5f}};
    const Polygon outside{{0, 0}, {1.5f, 0}, {0.2f, 0.2f}, {0, 1}};
    Polygons fan;  // three triangles that meet in the middle
    for (int i = 0; i < 3; ++i) {
        const float angle = kTau * static_cast<float>(i) / 3.0f;
        const Vec2 middle{0.5f, 0.5f};
        fan.push_back({middle, middle + Vec2{cosine(angle), sine(angle)} * 0.4f,
                       middle + Vec2{cosine(angle + 0.5f), sine(angle + 0.5f)} * 0.4f});
    }
    const Polygons many(90, {{0, 0}, {1, 0}, {0, 1}});
    for (const Polygons& bad : {Polygons{}, Polygons{line}, Polygons{outside}, fan, many}) {
        const auto added = palette.addPolygons(bad);
        ASSERT_FALSE(added.ok());
        EXPECT_FALSE(added.error().remedy.empty());
    }
    EXPECT_FALSE(palette.hasForm(TileForm::Count));
}

TEST(TileArea, oneWayFormsStopOnlyOnTheEdgesOfTheirSide) {
    TilePalette palette;
    const Polygon stairs{{0, 1}, {0, 0.5f}, {0.5f, 0.5f}, {0.5f, 0}, {1, 0}, {1, 1}};
    const TileOutline& outline = palette.outline(*palette.addPolygons(Polygons{stairs}, OneWay::Up));
    EXPECT_FALSE(outline.isSolid());
    std::int32_t width = 0;
    for (const TileOutline::Edge& edge : outline.edges) {
        if (edge.stops) width += edge.b.x - edge.a.x;
        EXPECT_EQ(edge.stops, edge.b.x > edge.a.x);
    }
    EXPECT_EQ(width, kCellUnits);
    for (const std::vector<FaceSpan>& spans : outline.spans) EXPECT_TRUE(spans.empty());
}

/// A form of random boxes on a grid of quarter cells: concave, in several parts, with holes.
TileForm randomBoxes(TilePalette& palette, Random& random) {
    Polygons boxes;
    for (std::uint32_t i = 1 + random.below(5); i > 0; --i) {
        const auto x = static_cast<float>(random.below(4)) / 4, y = static_cast<float>(random.below(4)) / 4;
        const float right = x + static_cast<float>(1 + random.below(4)) / 4;
        const float bottom = y + static_cast<float>(1 + random.below(4)) / 4;
        const Vec2 low{x, y}, high{std::min(right, 1.0f), std::min(bottom, 1.0f)};
        boxes.push_back({low, {high.x, low.y}, high, {low.x, high.y}});
    }
    return *palette.addPolygons(boxes);
}

// Sides that neighbours share have no edges, whatever parts of them each cell fills: outlines are closed, and
// what they enclose is the union of the cells.
TEST(TileArea, cellsOfSeveralPartsFormOneOutline) {
    for (int seed = 0; seed < masksToTry(200); ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(static_cast<std::uint64_t>(seed));
        TileMask mask{9, 9};
        std::vector<TileForm> forms{TileForm::Full, TileForm::SlopeUp, TileForm::SlopeDown, TileForm::Empty};
        for (int i = 0; i < 6; ++i) {
            const TileForm form = randomBoxes(mask.palette, random);
            forms.push_back(*mask.palette.flipped(form, random.next() & kTileFlips));
        }
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 9; ++x)
                mask.set(x, y, {forms[random.below(static_cast<std::uint32_t>(forms.size()))]});
        }
        const TerrainOutlines terrain = built(mask, 4);
        const std::vector<TerrainSegment> segments = allSegments(terrain);
        std::int64_t area = 0;
        for (const TerrainSegment& segment : segments) {
            area += cross(segment.a, segment.b);
            const auto continues = [&](const TerrainSegment& next) {
                return next.a == segment.b && next.b == segment.after && next.before == segment.a;
            };
            // A chunk may cut a straight line, beyond which the ghost is the next edge of a cell.
            const auto isCut = [&](const TerrainSegment& next) {
                return next.a == segment.b && cross(next.b - next.a, segment.after - segment.b) == 0;
            };
            EXPECT_TRUE(std::any_of(segments.begin(), segments.end(), continues) ||
                        std::any_of(segments.begin(), segments.end(), isCut));
            // The right side is solid, the left one is open.
            const Vec2 a = toMetres(segment.a, {1, 1}), b = toMetres(segment.b, {1, 1});
            const Vec2 along = (b - a) / length(b - a) * 0.01f;
            const Vec2 middle = a + (b - a) * 0.437f;
            EXPECT_EQ(turnsAround(segments, middle + Vec2{-along.y, along.x}), 1);
            EXPECT_EQ(turnsAround(segments, middle - Vec2{-along.y, along.x}), 0);
        }
        EXPECT_EQ(area, doubleAreaOf(mask));
    }
}

}  // namespace
}  // namespace plumb::physics
