#include <gtest/gtest.h>

#include "physics/terrain/terrain_outlines.hpp"
#include "tests/physics/support/random_terrain.hpp"

namespace plumb::physics {
namespace {

using namespace test;

constexpr GridPoint at(double x, double y) {
    return {static_cast<std::int32_t>(x * kCellUnits), static_cast<std::int32_t>(y * kCellUnits)};
}

/// Builds the outline of a map that fits in one chunk.
TerrainOutline outlineOf(const TileMask& mask) {
    TerrainOutline outline;
    OutlineBuilder{}.build(mask, {0, 0, mask.width(), mask.height()}, outline);
    return outline;
}

/// Returns the segment that begins at a point; the test fails unless there is exactly one.
TerrainSegment from(const TerrainOutline& outline, GridPoint a) {
    const auto begins = [a](const TerrainSegment& segment) { return segment.a == a; };
    EXPECT_EQ(std::count_if(outline.begin(), outline.end(), begins), 1);
    const auto found = std::find_if(outline.begin(), outline.end(), begins);
    return found != outline.end() ? *found : TerrainSegment{};
}

TEST(Outlines, ofAnEmptyMapAreEmpty) {
    EXPECT_EQ(outlineOf(TileMask{}), TerrainOutline{});
    EXPECT_EQ(outlineOf(TileMask{1, 1}), TerrainOutline{});
    EXPECT_EQ(outlineOf(TileMask{32, 32}), TerrainOutline{});
}

TEST(Outlines, ofOneTileAreItsFourSidesClockwiseOnScreenWithNormalsOutward) {
    const TerrainOutline outline = outlineOf(drawn({"#"}));

    ASSERT_EQ(outline.size(), 4u);
    constexpr Vec2 kNormals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
        const TerrainSegment& side = outline[i];
        EXPECT_EQ(side.b, outline[(i + 1) % 4].a);
        EXPECT_EQ(side.before, outline[(i + 3) % 4].a);
        EXPECT_EQ(side.after, outline[(i + 1) % 4].b);
        EXPECT_EQ(normalOfChain(geometryOf(side, {0.5f, 0.5f})), kNormals[i]);
    }
}

TEST(Outlines, ofAFullMapAreItsFourBorders) {
    TileMask mask{32, 32};
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) mask.set(x, y, {TileForm::Full});
    }
    const TerrainOutline outline = outlineOf(mask);
    EXPECT_EQ(outline.size(), 4u);
    EXPECT_EQ(from(outline, at(0, 0)).b, at(32, 0));
}

TEST(Outlines, ofAHoleHaveTheOppositeOrientation) {
    const TerrainOutline outline = outlineOf(drawn({"#####", "#...#", "#.#.#", "#...#", "#####"}));
    ASSERT_EQ(outline.size(), 12u);
    // The hole's left wall runs downwards, so that its normal points right.
    EXPECT_EQ(from(outline, at(1, 1)).b, at(1, 4));
    // The solid cell inside the hole has the orientation of any other solid.
    EXPECT_EQ(from(outline, at(2, 2)).b, at(3, 2));
}

TEST(Outlines, ofNarrowCorridorsHaveBothWalls) {
    const TerrainOutline outline = outlineOf(drawn({"########", "#......#", "######.#"}));
    EXPECT_EQ(from(outline, at(7, 1)).b, at(1, 1));  // ceiling
    EXPECT_EQ(from(outline, at(1, 2)).b, at(6, 2));  // floor
    EXPECT_EQ(from(outline, at(1, 2)).after, at(6, 3));
}

TEST(Outlines, stayOnTheOpenSideWhereTwoSolidsTouchInAPoint) {
    const TerrainOutline outline = outlineOf(drawn({"#.", ".#"}));
    ASSERT_EQ(outline.size(), 8u);
    // all segments form one chain
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(outline[i].b, outline[(i + 1) % 8].a);
    const auto wall =
        std::find_if(outline.begin(), outline.end(), [](const TerrainSegment& s) { return s.a == at(1, 0); });
    ASSERT_NE(wall, outline.end());
    EXPECT_EQ(wall->b, at(1, 1));
    // The wall continues with the floor of its pocket, not with the underside of its own tile.
    EXPECT_EQ(wall->after, at(2, 1));
}

TEST(Outlines, ofACheckerboardStayWithinEachPocket) {
    TileMask mask{8, 8};
    for (int y = 0; y < 8; ++y) {
        for (int x = y % 2; x < 8; x += 2) mask.set(x, y, {TileForm::Full});
    }
    const TerrainOutline outline = outlineOf(mask);
    EXPECT_EQ(outline.size(), 4u * 32);
    for (const TerrainSegment& s : outline) {
        const bool inside = s.b.x > 0 && s.b.y > 0 && s.b.x < at(8, 8).x && s.b.y < at(8, 8).y;
        EXPECT_TRUE(!inside || cross(s.b - s.a, s.after - s.b) < 0);
    }
}

TEST(Outlines, ofTouchingSolidsOfDifferentLayersStaySeparate) {
    TileMask mask{2, 2};
    const std::uint8_t other = *mask.palette.addLayers({2, 0xffffffffu});
    mask.set(0, 0, {TileForm::Full});
    mask.set(1, 1, {TileForm::Full, 0, other});
    const TerrainOutline outline = outlineOf(mask);
    ASSERT_EQ(outline.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(outline[i].b, outline[i / 4 * 4 + (i + 1) % 4].a);
}

TEST(Outlines, splitWhereTheMaterialChangesButGoOnAsGhosts) {
    TileMask mask = drawn({"####"});
    const std::uint8_t ice = *mask.palette.addMaterial({.friction = 0.0f});
    for (const int x : {2, 3}) mask.set(x, 0, {TileForm::Full, ice});
    const TerrainOutline outline = outlineOf(mask);

    EXPECT_EQ(outline.size(), 6u);  // no edge between the two materials
    const TerrainSegment stone = from(outline, at(0, 0));
    const TerrainSegment icy = from(outline, at(2, 0));
    EXPECT_EQ(stone.b, at(2, 0));
    EXPECT_EQ(stone.after, at(4, 0));
    EXPECT_EQ(icy.before, at(0, 0));
    EXPECT_EQ(icy.kind.material, ice);
    EXPECT_EQ(stone.kind.material, 0);
}

TEST(Outlines, haveNoVertexBetweenASlopeAndTheFloorItStandsOn) {
    const TerrainOutline outline = outlineOf(drawn({"./#", "###"}));
    EXPECT_EQ(from(outline, at(0, 1)).b, at(1, 1));
    EXPECT_EQ(from(outline, at(1, 1)).b, at(2, 0));
    EXPECT_EQ(from(outline, at(1, 1)).after, at(3, 0));
    EXPECT_EQ(outline.size(), 6u);
}

TEST(Outlines, mergeSlopesOverManyTiles) {
    const TerrainOutline outline = outlineOf(drawn({"../#", "./##", "/###"}));
    EXPECT_EQ(from(outline, at(0, 3)).b, at(3, 0));
    EXPECT_EQ(outline.size(), 4u);
}

TEST(Outlines, goOnAcrossTheBordersOfChunks) {
    const TerrainOutlines terrain = built(drawn({"............", "############"}), 4);
    const TerrainOutline& middle = terrain.chunks()[1];
    ASSERT_EQ(middle.size(), 2u);  // floor and underside; no edge along the chunk border
    const TerrainSegment floor = from(middle, at(4, 1));
    EXPECT_EQ(floor.b, at(8, 1));
    EXPECT_EQ(floor.before, at(3, 1));
    EXPECT_EQ(floor.after, at(9, 1));
}

TEST(Outlines, ofOneWayTilesAreTheirTopsAlone) {
    const TerrainOutline outline = outlineOf(drawn({"...", "---", "---"}));
    ASSERT_EQ(outline.size(), 2u);
    const TerrainSegment& top = outline[0];
    EXPECT_EQ(top.a, at(0, 1));
    EXPECT_EQ(top.b, at(3, 1));
    EXPECT_EQ(top.kind.oneWay, OneWay::Up);
    EXPECT_EQ(top.before, at(-3, 1));  // free ends are extended straight on, so that nothing catches there
    EXPECT_EQ(top.after, at(6, 1));
}

TEST(Outlines, ofOneWayTilesEndAtWallsAndContinueAtFloors) {
    const TerrainOutline outline = outlineOf(drawn({"#...", "#--#", "#..#"}));
    const TerrainSegment platform = from(outline, at(1, 1));
    EXPECT_EQ(platform.b, at(3, 1));
    EXPECT_EQ(platform.before, at(1, 0));  // the wall to its left
    EXPECT_EQ(platform.after, at(4, 1));   // the floor to its right
    const auto begins = [](GridPoint a, GridPoint b) {
        return [a, b](const TerrainSegment& s) { return s.a == a && s.b == b; };
    };
    const auto floor = std::find_if(outline.begin(), outline.end(), begins(at(3, 1), at(4, 1)));
    const auto side = std::find_if(outline.begin(), outline.end(), begins(at(3, 3), at(3, 1)));
    ASSERT_NE(floor, outline.end());
    ASSERT_NE(side, outline.end());
    EXPECT_EQ(floor->before, at(1, 1));              // nothing catches between platform and floor
    EXPECT_EQ(side->after, at(4, 1));                // from below, the block has a corner here
    EXPECT_EQ(from(outline, at(1, 0)).b, at(1, 3));  // the wall is one segment
}

TEST(Outlines, ofFloorsIgnoreOneWaySlopesThatStandOnThem) {
    TileMask mask = drawn({"....", "####"});
    const std::uint8_t ice = *mask.palette.addMaterial({.friction = 0.0f});
    for (const int x : {2, 3}) mask.set(x, 1, {TileForm::Full, ice});
    mask.set(2, 0, {*mask.palette.withOneWay(TileForm::SlopeUp, OneWay::Up)});
    const TerrainOutline outline = outlineOf(mask);
    EXPECT_EQ(from(outline, at(0, 1)).after, at(4, 1));
    for (const TerrainSegment& s : outline) {
        EXPECT_TRUE(s.kind.oneWay == OneWay::No || s.before == at(0, 1));
    }
}

TEST(Outlines, ofOneWayTilesContinueStraightWhereASlopeBendsAway) {
    const TerrainOutline outline = outlineOf(drawn({"..", "-\\"}));
    EXPECT_EQ(from(outline, at(0, 1)).after, at(2, 1));  // straight on
    const TerrainSegment slope = from(outline, at(1, 1));
    EXPECT_EQ(slope.b, at(2, 2));
    EXPECT_EQ(slope.before, at(0, 1));
}

TEST(Outlines, ofAOneWayTileUnderASolidOneAreEmpty) {
    const TerrainOutline outline = outlineOf(drawn({"#", "-"}));
    EXPECT_EQ(outline.size(), 4u);
}

TEST(Outlines, ofOneWayTilesFaceTheirDirection) {
    constexpr Vec2 kNormals[] = {{0, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    for (const OneWay side : {OneWay::Up, OneWay::Right, OneWay::Down, OneWay::Left}) {
        TileMask mask{1, 1};
        mask.set(0, 0, {*mask.palette.withOneWay(TileForm::Full, side)});
        const TerrainOutline outline = outlineOf(mask);
        ASSERT_EQ(outline.size(), 1u);
        EXPECT_EQ(normalOfChain(geometryOf(outline[0], {1, 1})), kNormals[static_cast<int>(side)]);
    }
}

TEST(Outlines, betweenLayersStopBodiesThatDoNotCollideWithTheOtherLayer) {
    TileMask mask{2, 1};
    const std::uint8_t two = *mask.palette.addLayers({2, 0xffffffffu});
    mask.set(0, 0, {TileForm::Full});
    mask.set(1, 0, {TileForm::Full, 0, two});
    const TerrainOutline outline = outlineOf(mask);

    const auto inner = [&](GridPoint a) {
        return *std::find_if(outline.begin(), outline.end(),
                             [a](const TerrainSegment& s) { return s.a == a && s.kind.isInner(); });
    };
    EXPECT_EQ(outline.size(), 8u);
    const TerrainSegment right = inner(at(1, 0));  // right edge of the left tile
    EXPECT_EQ(right.b, at(1, 1));
    EXPECT_EQ(right.kind, (EdgeKind{0, 0, OneWay::No, static_cast<std::uint8_t>(two + 1)}));
    // For shapes that collide with the left tile only, this tile stands alone.
    EXPECT_EQ(right.before, at(0, 0));
    EXPECT_EQ(right.after, at(0, 1));
    const TerrainSegment left = inner(at(1, 1));
    EXPECT_EQ(left.kind, (EdgeKind{0, two, OneWay::No, 1}));
    EXPECT_EQ(left.after, at(2, 0));
    // For shapes that collide with both tiles, the common floor is smooth.
    EXPECT_EQ(std::count_if(outline.begin(), outline.end(),
                            [](const TerrainSegment& s) { return s.a == at(0, 0) && s.after == at(2, 0); }),
              1);
}

TEST(Outlines, betweenLayersExistOnlyIfTheOtherLayerCollidesWithFewerShapes) {
    TileMask mask{2, 1};
    const std::uint8_t both = *mask.palette.addLayers({3, 0xffffffffu});
    mask.set(0, 0, {TileForm::Full});
    mask.set(1, 0, {TileForm::Full, 0, both});
    const TerrainOutline outline = outlineOf(mask);
    // No inner edge, as shapes that collide with the left tile also collide with the right one.
    EXPECT_EQ(outline.size(), 7u);
}

TEST(Outlines, inMetresAreExactNearTheirChunk) {
    const TerrainSegment far{cornerOfCell(40000, 3), cornerOfCell(40001, 3), {}, {}, {}};
    const Geometry geometry = geometryOf(far, {0.1f, 0.1f}, cornerOfCell(39999, 0));
    EXPECT_EQ(geometry.kind, ShapeKind::ChainSegment);
    EXPECT_EQ(geometry.a, (Vec2{0.1f, 3 * 0.1f}));
    EXPECT_EQ(geometry.b, (Vec2{2 * 0.1f, 3 * 0.1f}));
}

}  // namespace
}  // namespace plumb::physics
