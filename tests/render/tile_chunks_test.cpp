#include "render/tile_chunks.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "render/recording_device.hpp"
#include "render/renderer.hpp"

namespace plumb {
namespace {

class TileChunksTest : public testing::Test {
protected:
    TileChunksTest() {
        for (int i = 0; i < 4; ++i)
            looks.push_back({TextureHandle{1}, {static_cast<float>(i) * 16.0f, 0.0f, 16.0f, 16.0f}});
        sheet.looks = looks;
        for (int y = 0; y < grid.height(); ++y) {
            for (int x = 0; x < grid.width(); ++x) grid.set(x, y, cellOf((x + y) % 4));
        }
    }

    void draw() {
        device.clearDraws();
        list.begin(view);
        chunks.draw(list, grid, sheet, placement);
        renderer.draw(list, {.width = 320, .height = 180});
    }
    [[nodiscard]] std::size_t tilesDrawn() const {
        std::size_t count = 0;
        for (const RecordingDevice::SpriteDraw& draw : device.spriteDraws) count += draw.instances.size();
        return count;
    }

    RecordingDevice device;
    Renderer renderer{device};
    DrawList list;
    TileChunks chunks{device};
    std::vector<TileLook> looks;
    TileSheet sheet;
    TilePlacement placement;
    TileGrid grid{100, 100};
    View view{.center = {800.0f, 800.0f}, .size = {320.0f, 180.0f}};
};

TEST_F(TileChunksTest, onlyVisibleChunksAreBuiltAndOnlyOnce) {
    view.center = {256.0f, 256.0f};
    for (int i = 0; i < 5; ++i) draw();
    EXPECT_EQ(chunks.builtCount(), 1u);
    EXPECT_EQ(device.drawCalls(), 1u);
    EXPECT_EQ(tilesDrawn(), 32u * 32u);
    view.center = {512.0f, 512.0f};
    draw();
    EXPECT_EQ(chunks.builtCount(), 4u);
    EXPECT_EQ(device.drawCalls(), 4u);
}

TEST_F(TileChunksTest, aChangedTileRebuildsOnlyItsChunk) {
    view.center = {512.0f, 512.0f};
    draw();
    ASSERT_EQ(chunks.builtCount(), 4u);
    grid.set(40, 30, cellOf(3));
    draw();
    EXPECT_EQ(chunks.builtCount(), 5u);
    grid.set(99, 99, cellOf(1));
    draw();
    EXPECT_EQ(chunks.builtCount(), 5u) << "a changed invisible chunk is not rebuilt";
}

TEST_F(TileChunksTest, everyTileIsDrawnExactlyOnceAtItsCell) {
    grid = TileGrid{70, 40};
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 70; ++x) grid.set(x, y, (x * 7 + y) % 3 == 0 ? 0 : cellOf(0));
    }
    view.zoom = 0.1f;
    draw();
    std::vector<int> seen(70 * 40);
    for (const RecordingDevice::SpriteDraw& shown : device.spriteDraws) {
        for (const SpriteInstance& tile : shown.instances) {
            EXPECT_EQ(tile.half, (Vec2{8.0f, 8.0f}));
            const int x = static_cast<int>(tile.center.x) / 16;
            const int y = static_cast<int>(tile.center.y) / 16;
            ++seen[static_cast<std::size_t>(y * 70 + x)];
        }
    }
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 70; ++x)
            EXPECT_EQ(seen[static_cast<std::size_t>(y * 70 + x)], grid.at(x, y) == 0 ? 0 : 1);
    }
}

/// Counts pairs of overlapping tiles that are drawn in the wrong order. The right order is that of the cells:
/// row by row from the top, each row from the left.
int wronglyOverlapping(const RecordingDevice& device, float cell) {
    std::vector<SpriteInstance> drawn;
    for (const RecordingDevice::SpriteDraw& draw : device.spriteDraws)
        drawn.insert(drawn.end(), draw.instances.begin(), draw.instances.end());
    // Returns a number that increases in the order of cells, from the tile's lower left corner.
    const auto placeOf = [&](const SpriteInstance& tile) {
        const float row = (tile.center.y + tile.half.y) / cell;
        return static_cast<int>(row) * 10000 + static_cast<int>((tile.center.x - tile.half.x) / cell);
    };
    int wrong = 0;
    for (std::size_t later = 0; later < drawn.size(); ++later) {
        for (std::size_t i = 0; i < later; ++i) {
            const Vec2 apart = drawn[later].center - drawn[i].center;
            const Vec2 reach = drawn[later].half + drawn[i].half;
            const bool overlap = std::abs(apart.x) < reach.x && std::abs(apart.y) < reach.y;
            wrong += overlap && placeOf(drawn[later]) < placeOf(drawn[i]) ? 1 : 0;
        }
    }
    return wrong;
}

TEST_F(TileChunksTest, largeTilesLieOverEachOtherInTheOrderOfTheirCells) {
    const Rect sizes[] = {{0, 0, 32, 32}, {0, 0, 16, 40}, {0, 0, 40, 16}, {0, 0, 24, 20}};
    for (const Rect& size : sizes) {
        for (const bool animated : {false, true}) {
            SCOPED_TRACE(testing::Message() << size.width << " x " << size.height << ", " << animated);
            for (TileLook& look : looks) look.source = size;
            looks[2].animated = animated;
            sheet.looks = looks;
            ++sheet.version;
            view = {.center = {520.0f, 520.0f}, .size = {320.0f, 180.0f}};
            draw();
            EXPECT_GT(tilesDrawn(), 200u);
            EXPECT_EQ(wronglyOverlapping(device, 16.0f), 0);
        }
    }
}

/// Isometric maps are imported with cells of half the tile size.
TEST_F(TileChunksTest, tilesInAGridOfHalfCellsLieOverEachOtherInTheOrderOfTheirRows) {
    for (TileLook& look : looks) look.source = {0.0f, 0.0f, 32.0f, 24.0f};
    sheet.cellSize = {16.0f, 8.0f};
    sheet.version = 1;
    view.center = {512.0f, 256.0f};
    draw();
    EXPECT_GT(tilesDrawn(), 200u);
    EXPECT_EQ(wronglyOverlapping(device, 8.0f), 0);
}

TEST_F(TileChunksTest, movingTheLayerRebuildsNothing) {
    view.center = {256.0f, 256.0f};
    draw();
    placement.offset = {3.0f, -2.0f};
    draw();
    EXPECT_EQ(chunks.builtCount(), 1u);
    EXPECT_EQ(device.spriteDraws.front().batch.transform, movedBy(transformOf(view), {3.0f, -2.0f}));
}

TEST_F(TileChunksTest, animatedTilesAreDrawnByTheFrame) {
    view.center = {256.0f, 256.0f};
    grid = TileGrid{20, 20};
    grid.set(16, 16, cellOf(1));
    grid.set(17, 16, cellOf(2, kTileFlipX));
    looks[2].animated = true;
    draw();
    EXPECT_EQ(tilesDrawn(), 2u);
    looks[2].source.x = 0.0f;
    draw();
    EXPECT_EQ(chunks.builtCount(), 1u);
    ASSERT_EQ(device.spriteDraws.size(), 2u);
    EXPECT_EQ(device.spriteDraws[1].instances[0].uv, (std::array<std::uint16_t, 4>{64, 0, 0, 64}));
}

TEST_F(TileChunksTest, flipsAreAppliedDiagonalFirst) {
    grid = TileGrid{3, 1};
    view.center = {24.0f, 8.0f};
    grid.set(0, 0, cellOf(0, kTileFlipX));
    grid.set(1, 0, cellOf(0, kTileFlipDiagonal));
    grid.set(2, 0, cellOf(0, kTileFlipDiagonal | kTileFlipX));
    draw();
    const std::vector<SpriteInstance>& tiles = device.spriteDraws.front().instances;
    EXPECT_EQ(tiles[0].uv, (std::array<std::uint16_t, 4>{64, 0, 0, 64}));
    EXPECT_EQ(tiles[1].uv, (std::array<std::uint16_t, 4>{0, 0, 64, 64}));
    EXPECT_EQ(tiles[2].uv, (std::array<std::uint16_t, 4>{0, 64, 64, 0}));
    EXPECT_EQ(tiles[0].slot & kSpriteDiagonal, 0u);
    EXPECT_NE(tiles[2].slot & kSpriteDiagonal, 0u);
}

TEST_F(TileChunksTest, tilesOfManyImagesAreSplitIntoBatchesOfSixteenTextures) {
    looks.clear();
    for (std::uint32_t i = 0; i < 40; ++i)
        looks.push_back({TextureHandle{i + 1}, {0.0f, 0.0f, 16.0f, 16.0f}});
    sheet.looks = looks;
    sheet.version = 1;
    grid = TileGrid{20, 20};
    view.center = {160.0f, 160.0f};
    view.zoom = 0.5f;
    for (int i = 0; i < 400; ++i) grid.set(i % 20, i / 20, cellOf(i / 10));
    draw();
    EXPECT_EQ(device.drawCalls(), 3u);
    EXPECT_EQ(tilesDrawn(), 400u);
}

TEST_F(TileChunksTest, picturesLargerThanACellStandOnItAndStaySeen) {
    looks[0].source = {0.0f, 0.0f, 16.0f, 64.0f};
    sheet.version = 1;
    grid = TileGrid{1, 100};
    grid.set(0, 33, cellOf(0));  // the tile extends up to row 30, into the chunk above
    view.center = {8.0f, 490.0f};
    view.size = {16.0f, 16.0f};
    draw();
    ASSERT_EQ(tilesDrawn(), 1u);
    const SpriteInstance& tile = device.spriteDraws.front().instances.front();
    EXPECT_EQ(tile.center.y + tile.half.y, 34.0f * 16.0f);
}

TEST_F(TileChunksTest, aHugeLayerZoomedOutNeedsFewQuads) {
    std::vector<TileCell> cells(2048 * 2048, cellOf(1));
    grid.replaceCells(2048, 2048, std::move(cells));
    view.center = {2048.0f * 8.0f, 2048.0f * 8.0f};
    view.zoom = 180.0f / (2048.0f * 16.0f);
    draw();
    EXPECT_LE(tilesDrawn(), 180u * 180u);
    EXPECT_GE(tilesDrawn(), 60u * 60u);
    EXPECT_LE(device.drawCalls(), 25u);
    // All blocks together cover the layer.
    double area = 0.0;
    for (const RecordingDevice::SpriteDraw& shown : device.spriteDraws) {
        for (const SpriteInstance& tile : shown.instances)
            area += 4.0 * static_cast<double>(tile.half.x * tile.half.y);
    }
    EXPECT_EQ(area, 2048.0 * 2048.0 * 256.0);
}

TEST_F(TileChunksTest, chunksReleaseTheirMemory) {
    view.zoom = 0.1f;
    draw();
    EXPECT_EQ(chunks.keptCount(), 16u);
    chunks.forget();
    EXPECT_EQ(chunks.keptCount(), 0u);
    draw();
    EXPECT_EQ(chunks.keptCount(), 16u);
}

}  // namespace
}  // namespace plumb
