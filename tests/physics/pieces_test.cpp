#include "physics/terrain/pieces.hpp"

#include <gtest/gtest.h>

#include "tests/physics/random_terrain.hpp"

namespace plumb::physics {
namespace {

using namespace test;

std::vector<TerrainPiece> piecesOf(const TileMask& mask) {
    std::vector<TerrainPiece> pieces;
    PieceBuilder{}.build(mask, {0, 0, mask.width(), mask.height()}, pieces);
    return pieces;
}

std::int64_t doubleAreaOf(const PieceCorners& corners) {
    std::int64_t sum = 0;
    for (int i = 0; i < corners.count; ++i) {
        sum += cross(corners.points[static_cast<std::size_t>(i)],
                     corners.points[static_cast<std::size_t>((i + 1) % corners.count)]);
    }
    return sum;
}

/// Every solid cell has the piece's flags, and no cell has two pieces.
void expectPiecesAreTheirCells(const TileMask& mask, const std::vector<TerrainPiece>& pieces,
                               std::int64_t& area) {
    std::vector<int> owners(static_cast<std::size_t>(mask.width()) * static_cast<std::size_t>(mask.height()));
    for (const TerrainPiece& piece : pieces) {
        area += doubleAreaOf(cornersOf(piece, mask.palette));
        for (int y = piece.min.y / kCellUnits; y * kCellUnits < piece.max.y; ++y) {
            for (int x = piece.min.x / kCellUnits; x * kCellUnits < piece.max.x; ++x) {
                ASSERT_EQ(mask.at(x, y), piece.cell);
                ++owners[static_cast<std::size_t>(y * mask.width() + x)];
            }
        }
    }
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            const bool solid = mask.palette.outline(mask.at(x, y).form).isSolid();
            ASSERT_EQ(owners[static_cast<std::size_t>(y * mask.width() + x)], solid ? 1 : 0);
        }
    }
}

TEST(Pieces, ofRandomMasksHaveTheTilesAreaAndFlagsAndDoNotOverlap) {
    const int count = masksToTry(2000);
    for (int seed = 0; seed < count; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(static_cast<std::uint64_t>(seed));
        const TileMask mask = randomMask(32, 32, random);
        std::int64_t area = 0;
        expectPiecesAreTheirCells(mask, piecesOf(mask), area);
        ASSERT_EQ(area, test::doubleAreaOf(mask));
    }
}

TEST(Pieces, ofNothingAreNothing) {
    EXPECT_TRUE(piecesOf(TileMask{}).empty());
    EXPECT_TRUE(piecesOf(TileMask{32, 32}).empty());
    EXPECT_TRUE(piecesOf(drawn({"---"})).empty());  // one can be inside of nothing
}

TEST(Pieces, mergeEqualCellsToTheFewestBoxesThatRowsGive) {
    const std::vector<TerrainPiece> pieces = piecesOf(drawn({"####", "####", "##.."}));
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(pieces[0].max, (cornerOfCell(4, 2)));
    EXPECT_EQ(pieces[1].min, (cornerOfCell(0, 2)));
    EXPECT_EQ(pieces[1].max, (cornerOfCell(2, 3)));
}

TEST(Pieces, mergeHalvesOnlyAlongTheirLength) {
    TileMask mask{2, 2};
    for (int i = 0; i < 4; ++i) mask.set(i % 2, i / 2, {TileForm::HalfTop});
    EXPECT_EQ(piecesOf(mask).size(), 2u);
    for (int i = 0; i < 4; ++i) mask.set(i % 2, i / 2, {TileForm::HalfRight});
    const std::vector<TerrainPiece> tall = piecesOf(mask);
    ASSERT_EQ(tall.size(), 2u);
    EXPECT_EQ(tall[0].min, (GridPoint{kCellUnits / 2, 0}));
    EXPECT_EQ(tall[0].max, (cornerOfCell(1, 2)));
}

TEST(Pieces, keepSlopesAsTheyAre) {
    const TileMask mask = drawn({"./"});
    const std::vector<TerrainPiece> pieces = piecesOf(mask);
    ASSERT_EQ(pieces.size(), 1u);
    const PieceCorners corners = cornersOf(pieces[0], mask.palette);
    EXPECT_EQ(corners.count, 3);
    EXPECT_EQ(corners.points[0], (cornerOfCell(2, 0)));
}

}  // namespace
}  // namespace plumb::physics
