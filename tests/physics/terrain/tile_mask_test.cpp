#include "physics/terrain/tile_mask.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tests/physics/support/random_terrain.hpp"

namespace plumb::physics {
namespace {

constexpr std::int64_t kWhole = 2 * std::int64_t{kCellUnits} * kCellUnits;

TEST(TilePalette, builtInFormsHaveTheirAreas) {
    constexpr double kAreas[] = {0, 1, 1, 0.5, 0.5, 0.25, 0.75, 0.75, 0.25, 0.5, 0.5, 0.5, 0.5};
    const TilePalette palette;
    for (int form = 0; form < static_cast<int>(TileForm::Count); ++form) {
        SCOPED_TRACE(form);
        const TileOutline& outline = palette.outline(static_cast<TileForm>(form));
        EXPECT_EQ(test::doubleAreaOf(outline),
                  static_cast<std::int64_t>(kAreas[form] * static_cast<double>(kWhole)));
        EXPECT_EQ(outline.isSolid(), form != 0 && form != static_cast<int>(TileForm::OneWay));
    }
    EXPECT_FALSE(palette.hasForm(TileForm::Count));
}

TEST(TilePalette, reusesEqualForms) {
    TilePalette palette;
    constexpr Vec2 kCounterClockwise[] = {{0, 0}, {0, 1}, {1, 1}, {1, 0.5f}, {1, 0}};
    EXPECT_EQ(*palette.addPolygon(kCounterClockwise), TileForm::Full);
    EXPECT_EQ(*palette.addPolygon(kCounterClockwise, OneWay::Up), TileForm::OneWay);
    EXPECT_EQ(*palette.flipped(TileForm::SlopeUp, kTileFlipX), TileForm::SlopeDown);
    EXPECT_EQ(*palette.flipped(TileForm::SlopeUpLow, kTileFlipX), TileForm::SlopeDownLow);
    EXPECT_EQ(*palette.flipped(TileForm::HalfTop, kTileFlipDiagonal), TileForm::HalfLeft);
    EXPECT_EQ(*palette.flipped(TileForm::HalfTop, kTileFlipDiagonal | kTileFlipX), TileForm::HalfRight);
    EXPECT_EQ(*palette.flipped(TileForm::OneWay, kTileFlips), TileForm::OneWay);
    EXPECT_EQ(*palette.withOneWay(TileForm::OneWay, OneWay::No), TileForm::Full);
    EXPECT_EQ(*palette.flipped(TileForm::Empty, kTileFlips), TileForm::Empty);
    const TileForm first = *palette.flipped(TileForm::SlopeUp, kTileFlipY);
    EXPECT_EQ(first, TileForm::Count);
    EXPECT_EQ(*palette.flipped(TileForm::SlopeUp, kTileFlipY), first);
}

TEST(TilePalette, flipsFormsLikeDrawnTiles) {
    TilePalette palette;
    constexpr Vec2 kPoints[] = {{0.25f, 0}, {1, 0.5f}, {0, 1}};
    const TileForm form = *palette.addPolygon(kPoints);
    // Diagonal first: (0.25, 0) becomes (0, 0.25); then horizontally: (1, 0.25).
    const TileOutline& turned = palette.outline(*palette.flipped(form, kTileFlipDiagonal | kTileFlipX));
    const TileOutline expected = [&] {
        constexpr Vec2 kTurned[] = {{1, 0.25f}, {0.5f, 1}, {0, 0}};
        TilePalette other;
        return other.outline(*other.addPolygon(kTurned));
    }();
    EXPECT_EQ(turned, expected);
}

TEST(TilePalette, closesSeamsOfCarelesslyDrawnTiles) {
    TilePalette palette;
    constexpr Vec2 kAlmostFull[] = {{0.001f, -0.002f}, {1.002f, 0.001f}, {0.999f, 0.998f}, {0, 1}};
    EXPECT_EQ(*palette.addPolygon(kAlmostFull), TileForm::Full);
}

TEST(TilePalette, rejectsPolygonsThatAreNotConvexOrOutsideTheCell) {
    TilePalette palette;
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kHuge = std::numeric_limits<float>::max();
    const std::vector<std::vector<Vec2>> bad = {
        {},
        {{0, 0}},
        {{0, 0}, {1, 1}},
        {{0, 0}, {0.5f, 0.5f}, {1, 1}},
        {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}},
        {{0, 0}, {1, 0}, {0.2f, 0.2f}, {0, 1}},
        {{0, 0}, {1, 1}, {1, 0}, {0, 1}},
        {{0.5f, 0}, {0.8f, 1}, {0, 0.4f}, {1, 0.4f}, {0.2f, 1}},  // a star, which winds around twice
        {{0, 0}, {1.5f, 0}, {0, 1}},
        {{kNan, 0}, {1, 0}, {0, 1}},
        {{0, kHuge}, {1, 0}, {0, 1}},
        {{0, -kHuge}, {1, 0}, {0, 1}},
        std::vector<Vec2>(10000, Vec2{0.5f, 0.5f}),
        {{0.3f, 0},
         {0.7f, 0},
         {0.9f, 0.1f},
         {1, 0.3f},
         {1, 0.7f},
         {0.9f, 0.9f},
         {0.7f, 1},
         {0.3f, 1},
         {0, 0.5f}},
    };
    for (const std::vector<Vec2>& points : bad) {
        const auto added = palette.addPolygon(points);
        ASSERT_FALSE(added.ok()) << points.size();
        EXPECT_FALSE(added.error().remedy.empty());
    }
    EXPECT_FALSE(palette.hasForm(TileForm::Count));
}

TEST(TilePalette, keepsOnlyTheEdgesThatFaceTheOneWaySide) {
    TilePalette palette;
    const TileOutline& slope = palette.outline(*palette.withOneWay(TileForm::SlopeUp, OneWay::Up));
    int stops = 0;
    for (const TileOutline::Edge& edge : slope.edges) {
        if (!edge.stops) continue;
        ++stops;
        EXPECT_EQ(edge.a, (GridPoint{0, kCellUnits}));
        EXPECT_EQ(edge.b, (GridPoint{kCellUnits, 0}));
    }
    EXPECT_EQ(stops, 1);
    EXPECT_FALSE(slope.isSolid());
}

TEST(TilePalette, numbersMaterialsAndLayersAndRejectsInvalidOnes) {
    TilePalette palette;
    EXPECT_EQ(*palette.addMaterial({}), 0);
    EXPECT_EQ(*palette.addMaterial({.friction = 0.0f}), 1);
    EXPECT_EQ(*palette.addMaterial({.friction = 0.0f}), 1);
    EXPECT_EQ(*palette.addMaterial({.friction = 0.0f, .bounciness = 0.5f}), 2);
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    for (const float bad : {kNan, kInfinite, -kInfinite, -1.0f}) {
        EXPECT_FALSE(palette.addMaterial({.friction = bad}).ok());
        EXPECT_FALSE(palette.addMaterial({.bounciness = bad}).ok());
    }
    EXPECT_FALSE(palette.addMaterial({.bounciness = 1.1f}).ok());
    EXPECT_FALSE(palette.addMaterial({.surfaceSpeed = kNan}).ok());
    EXPECT_FALSE(palette.addMaterial({.friction = 101.0f}).ok()) << "a friction that shapes reject";
    EXPECT_FALSE(palette.addMaterial({.surfaceSpeed = 1.1e6f}).ok());
    EXPECT_EQ(*palette.addMaterial({.surfaceSpeed = -3.0f}), 3);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        EXPECT_EQ(palette.addMaterial({.friction = static_cast<float>(1 + i) / 64.0f}).ok(), i < 252);
        EXPECT_EQ(palette.addLayers({i, 0}).ok(), i < 254);
    }
    EXPECT_EQ(*palette.addLayers({}), 0);
    EXPECT_EQ(palette.layers(5).layers, 4u);
}

TEST(TilePalette, computesWhichLayersCoverOthers) {
    TilePalette palette;
    const std::uint8_t more = *palette.addLayers({3, 0xffffffffu});
    const std::uint8_t other = *palette.addLayers({2, 0xffffffffu});
    const std::uint8_t shy = *palette.addLayers({3, 1});
    EXPECT_TRUE(palette.covers(more, 0));
    EXPECT_FALSE(palette.covers(0, more));
    EXPECT_FALSE(palette.covers(0, other));
    EXPECT_FALSE(palette.covers(other, 0));
    EXPECT_TRUE(palette.covers(more, shy));
    EXPECT_FALSE(palette.covers(shy, more));
}

TEST(TileMask, isInitiallyEmptyAndStoresCells) {
    TileMask mask{3, 2};
    EXPECT_EQ(mask.at(2, 1), MaskCell{});
    EXPECT_TRUE(mask.set(2, 1, {TileForm::HalfTop}));
    EXPECT_FALSE(mask.set(2, 1, {TileForm::HalfTop}));
    EXPECT_EQ(mask.at(2, 1), MaskCell{TileForm::HalfTop});
    for (const auto& [x, y] : {std::pair{-1, 0}, {3, 0}, {0, -1}, {0, 2}, {2'000'000'000, -2'000'000'000}}) {
        EXPECT_FALSE(mask.set(x, y, {TileForm::Full}));
        EXPECT_EQ(mask.at(x, y), MaskCell{});
    }
}

TEST(TileMask, ofInvalidSizesIsClamped) {
    EXPECT_EQ(TileMask(-5, 10).width(), 0);
    EXPECT_EQ(TileMask(-5, 10).height(), 10);
    const TileMask thin{2'000'000'000, 3};
    EXPECT_EQ(thin.width(), TileMask::kMaxSide);
    EXPECT_EQ(thin.height(), 3);
}

TEST(CellWindow, readsRectanglesThatReachOverTheBorder) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        TileMask mask{1 + static_cast<int>(random.below(9)), 1 + static_cast<int>(random.below(9))};
        for (int i = 0; i < 40; ++i) {
            mask.set(static_cast<int>(random.below(9)), static_cast<int>(random.below(9)),
                     {static_cast<TileForm>(random.below(12))});
        }
        const int x = static_cast<int>(random.below(24)) - 12;
        const int y = static_cast<int>(random.below(24)) - 12;
        const CellRect rect{x, y, x + static_cast<int>(random.below(16)),
                            y + static_cast<int>(random.below(16))};
        CellWindow window;
        window.read(mask, rect);
        for (int row = rect.y0; row < rect.y1; ++row) {
            for (int column = rect.x0; column < rect.x1; ++column)
                EXPECT_EQ(maskCellOf(*window.cell(column, row)), mask.at(column, row));
        }
    }
}

}  // namespace
}  // namespace plumb::physics
