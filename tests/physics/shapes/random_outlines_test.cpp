#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/physics/support/random_terrain.hpp"

namespace plumb::physics {
namespace {

using namespace test;

/// Packs a step, the shortest part of an edge, whose ends are multiples of kStep, into one number: position,
/// direction and kind.
std::uint64_t stepKey(GridPoint a, GridPoint way, EdgeKind kind) {
    const auto part = [](std::int32_t units, int offset) {
        return static_cast<std::uint64_t>(units / kStep + offset);
    };
    std::uint64_t key = part(a.x, 8) << 10 | part(a.y, 8);
    key = key << 8 | part(way.x, 8) << 4 | part(way.y, 8);
    key = key << 8 | kind.material;
    key = key << 8 | kind.layers;
    return key << 11 | static_cast<std::uint64_t>(kind.oneWay) << 8 | kind.behind;
}

void appendSteps(GridPoint a, GridPoint b, EdgeKind kind, std::vector<std::uint64_t>& steps) {
    const GridPoint way = b - a;
    const std::int32_t count = std::gcd(way.x, way.y) / kStep;
    const GridPoint step{way.x / count, way.y / count};
    for (; a != b; a = a + step) steps.push_back(stepKey(a, step, kind));
}

bool isInside(const TileOutline& outline, GridPoint point) {
    for (const TileOutline::Edge& edge : outline.edges) {
        if (cross(edge.b - edge.a, point - edge.a) <= 0) return false;
    }
    return outline.isSolid();
}

/// Returns the solid cell whose interior contains a point; an empty cell if there is none.
MaskCell solidAt(const TileMask& mask, GridPoint point) {
    const int x = (point.x + kCellUnits) / kCellUnits - 1;
    const int y = (point.y + kCellUnits) / kCellUnits - 1;
    const MaskCell cell = mask.at(x, y);
    return isInside(mask.palette.outline(cell.form), point - cornerOfCell(x, y)) ? cell : MaskCell{};
}

/// Appends the open steps of one edge of a cell; a step is open depending on the cell in front of it.
void appendOpenSteps(const TileMask& mask, MaskCell cell, GridPoint a, GridPoint b,
                     std::vector<std::uint64_t>& steps) {
    const GridPoint way = b - a;
    const std::int32_t count = std::gcd(way.x, way.y) / kStep;
    const GridPoint step{way.x / count, way.y / count};
    const GridPoint outward{(way.y > 0) - (way.y < 0), (way.x < 0) - (way.x > 0)};
    for (; a != b; a = a + step) {
        const MaskCell front = solidAt(mask, a + GridPoint{step.x / 2, step.y / 2} + outward);
        EdgeKind kind{cell.material, cell.layers, mask.palette.outline(cell.form).oneWay, 0};
        if (front.form != TileForm::Empty) {
            if (mask.palette.covers(front.layers, cell.layers)) continue;
            kind.behind = static_cast<std::uint8_t>(front.layers + 1);
        }
        steps.push_back(stepKey(a, step, kind));
    }
}

/// Computes the expected edges directly from the tiles, without merging.
std::vector<std::uint64_t> stepsOfTiles(const TileMask& mask) {
    std::vector<std::uint64_t> steps;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            const TileOutline& outline = mask.palette.outline(mask.at(x, y).form);
            for (const TileOutline::Edge& edge : outline.edges) {
                const GridPoint way = edge.b - edge.a;
                if (!outline.isSolid() && dot({way.y, -way.x}, directionOf(outline.oneWay)) <= 0) continue;
                const GridPoint a = cornerOfCell(x, y) + edge.a;
                appendOpenSteps(mask, mask.at(x, y), a, a + way, steps);
            }
        }
    }
    std::sort(steps.begin(), steps.end());
    return steps;
}

std::vector<std::uint64_t> stepsOfOutlines(const TerrainOutlines& terrain) {
    std::vector<std::uint64_t> steps;
    for (const TerrainSegment& segment : allSegments(terrain)) {
        EXPECT_NE(segment.a, segment.b);
        appendSteps(segment.a, segment.b, segment.kind, steps);
    }
    std::sort(steps.begin(), steps.end());
    return steps;
}

std::int64_t doubleAreaOfOutlines(const TerrainOutlines& terrain) {
    std::int64_t sum = 0;
    for (const TerrainSegment& segment : allSegments(terrain)) {
        if (segment.kind.isPlain()) sum += cross(segment.a, segment.b);
    }
    return sum;
}

/// Expects that chains are connected, of one kind, and maximal: a segment that can be continued by another
/// one of its kind is followed by it in the list or closes its chain with it.
void expectGoodChains(const TerrainOutline& outline) {
    const auto isConnected = [](const TerrainSegment& one, const TerrainSegment& next) {
        return one.b == next.a && one.kind == next.kind;
    };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const TerrainSegment& one = outline[i];
        std::size_t first = i;
        while (first > 0 && isConnected(outline[first - 1], outline[first])) --first;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const TerrainSegment& next = outline[k];
            const bool couldJoin = isConnected(one, next) && next.b == one.after && next.before == one.a;
            if (!couldJoin || !one.kind.isPlain()) continue;
            EXPECT_NE(cross(one.b - one.a, next.b - next.a), 0);
            EXPECT_TRUE(k == i + 1 || (first <= k && k < i));
        }
    }
}

bool isOn(const TerrainSegment& segment, GridPoint point) {
    const GridPoint way = segment.b - segment.a;
    return cross(way, point - segment.a) == 0 && dot(way, point - segment.a) >= 0 &&
           dot(way, point - segment.b) <= 0;
}

/// True if all solid cells at a vertex have the same layers, and no one-way cell ends there.
bool isOrdinary(const TileMask& mask, GridPoint vertex) {
    int layers = -1;
    for (int dy = -1; dy <= 0; ++dy) {
        for (int dx = -1; dx <= 0; ++dx) {
            const MaskCell cell =
                mask.at((vertex.x + kCellUnits) / kCellUnits - 1 + dx + (vertex.x % kCellUnits != 0),
                        (vertex.y + kCellUnits) / kCellUnits - 1 + dy + (vertex.y % kCellUnits != 0));
            if (cell.form == TileForm::Empty) continue;
            if (!mask.palette.outline(cell.form).isSolid() || (layers >= 0 && layers != cell.layers))
                return false;
            layers = cell.layers;
        }
    }
    return true;
}

/// Expects that the wedge between two edges at a vertex, on the side of their normals, is empty, so that a
/// body that rotates around the vertex hits nothing there.
void expectOpenBetween(const TileMask& mask, GridPoint vertex, GridPoint from, GridPoint to) {
    const auto angle = [](GridPoint way) {
        return std::atan2(static_cast<double>(way.y), static_cast<double>(way.x));
    };
    const double start = angle(from - vertex);
    double turn = angle(to - vertex) - start;
    if (turn <= 1e-9) turn += 2 * 3.14159265358979323846;
    for (int i = 1; i < 16; ++i) {
        const double looking = start + turn * i / 16;
        const GridPoint point{
            vertex.x + static_cast<std::int32_t>(std::lround(std::cos(looking) * kStep / 8)),
            vertex.y + static_cast<std::int32_t>(std::lround(std::sin(looking) * kStep / 8))};
        ASSERT_EQ(solidAt(mask, point).form, TileForm::Empty) << "in the wedge " << i;
    }
}

/// True if some segment that begins at `vertex` (or ends there, for `backwards`) contains the ghost vertex.
/// In another chunk the ghost vertex may lie anywhere on that segment, not only at its far end.
bool isGhostOfSome(const std::vector<TerrainSegment>& segments, GridPoint vertex, GridPoint ghost,
                   bool backwards) {
    return std::any_of(segments.begin(), segments.end(), [&](const TerrainSegment& s) {
        return isOn(s, vertex) && isOn(s, ghost) && vertex != ghost &&
               (dot(s.b - s.a, ghost - vertex) < 0) == backwards;
    });
}

void expectGoodGhosts(const TerrainOutlines& terrain) {
    const std::vector<TerrainSegment> segments = allSegments(terrain);
    for (const TerrainSegment& s : segments) {
        const bool freeStart = s.before == s.a - (s.b - s.a);
        const bool freeEnd = s.after == s.b + (s.b - s.a);
        ASSERT_TRUE((freeStart && !s.kind.isPlain()) || isGhostOfSome(segments, s.a, s.before, true));
        ASSERT_TRUE((freeEnd && !s.kind.isPlain()) || isGhostOfSome(segments, s.b, s.after, false));
        if (!s.kind.isPlain()) continue;
        if (isOrdinary(terrain.mask(), s.b)) expectOpenBetween(terrain.mask(), s.b, s.a, s.after);
        if (isOrdinary(terrain.mask(), s.a)) expectOpenBetween(terrain.mask(), s.a, s.before, s.b);
    }
}

/// Expects that within a chunk successive segments have each other's far ends as ghost vertices.
void expectGhostsAgree(const TerrainOutlines& terrain) {
    for (const TerrainOutline& outline : terrain.chunks()) {
        for (const TerrainSegment& s : outline) {
            if (!s.kind.isPlain() || !isOrdinary(terrain.mask(), s.b)) continue;
            int followers = 0;
            for (const TerrainSegment& t : outline) {
                if (!t.kind.isPlain() || t.a != s.b || t.b != s.after) continue;
                ++followers;
                EXPECT_EQ(t.before, s.a);
            }
            EXPECT_EQ(followers, 1);
        }
    }
}

TEST(RandomOutlines, ofRandomMasksAreTheOpenEdgesOfTheTiles) {
    const int count = masksToTry(2000);
    for (int seed = 0; seed < count; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(static_cast<std::uint64_t>(seed));
        const TerrainOutlines terrain = built(randomMask(32, 32, random), 8 << random.below(3));

        const std::vector<std::uint64_t> expected = stepsOfTiles(terrain.mask());
        ASSERT_EQ(stepsOfOutlines(terrain), expected);
        ASSERT_EQ(std::adjacent_find(expected.begin(), expected.end()), expected.end());
        ASSERT_EQ(doubleAreaOfOutlines(terrain), doubleAreaOf(terrain.mask()));
    }
}

TEST(RandomOutlines, ofRandomMasksHaveConnectedChainsAndMatchingGhostVertices) {
    const int count = masksToTry(2000) / 5;
    for (int seed = 0; seed < count; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(static_cast<std::uint64_t>(seed) + 7'000'000);
        const int width = 1 + static_cast<int>(random.below(20));
        const int height = 1 + static_cast<int>(random.below(20));
        const int chunkCells = 4 + static_cast<int>(random.below(16));
        const TerrainOutlines terrain = built(randomMask(width, height, random), chunkCells);
        for (const TerrainOutline& outline : terrain.chunks()) expectGoodChains(outline);
        expectGoodGhosts(terrain);
        if (terrain.chunks().size() == 1) expectGhostsAgree(terrain);
        if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
}

}  // namespace
}  // namespace plumb::physics
