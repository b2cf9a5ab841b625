#include "assets/tileset.hpp"
#include "core/random.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/tiles/tile_palette.hpp"
#include "editor/model/tools/tile_tools.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

using Mode = TileTool::Mode;

/// The tile layer "ground" of the scene: 4 x 3 cells of 16 px with the rows "0 0 0 0", "0 1 1 0" and "2 2 2
/// 2".
class Tiles : public EditorFixture {
protected:
    [[nodiscard]] TileLayer& layer() {
        return workspace.document.world.get<TileLayer>(workspace.document.find(named("ground")));
    }
    [[nodiscard]] std::string row(int y) {
        const TileGrid& grid = *workspace.document.world.tiles().find(layer().cells);
        std::string text;
        for (int x = 0; x < grid.width(); ++x) text += std::to_string(grid.at(x, y));
        return text;
    }
    static Vec2 middleOf(int x, int y) {
        return {static_cast<float>(x) * 16.0f + 8.0f, static_cast<float>(y) * 16.0f + 8.0f};
    }
    void drag(Mode mode, CellPlace from, CellPlace to, Pointer how = {}) {
        TileTool tool{mode};
        drag(tool, from, to, how);
    }
    void drag(TileTool& tool, CellPlace from, CellPlace to, Pointer how = {}) {
        how.position = middleOf(from.x, from.y);
        tool.press(workspace.tools(), how);
        how.position = middleOf(to.x, to.y);
        tool.drag(workspace.tools(), how);
        tool.release(workspace.tools(), how);
    }
};

TEST_F(Tiles, aRectangleIsFilledInOneStepOnRelease) {
    workspace.tiles.stamp.cells = {5};
    drag(Mode::Rectangle, {2, 2}, {0, 1});
    EXPECT_EQ(row(0), "0000");
    EXPECT_EQ(row(1), "5550");
    EXPECT_EQ(row(2), "5552");
    EXPECT_EQ(workspace.undo.size(), 1u);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Tiles, aPatternRepeatsSeamlesslyAlongAStroke) {
    workspace.tiles.stamp = {2, 1, {3, 4}};
    drag(Mode::Brush, {0, 0}, {2, 0});
    EXPECT_EQ(row(0), "3434");
    EXPECT_EQ(workspace.undo.size(), 1u);
    drag(Mode::Rectangle, {0, 1}, {3, 2});
    EXPECT_EQ(row(1), "3434");
    EXPECT_EQ(row(2), "3434");
}

TEST_F(Tiles, theBucketFillsConnectedEqualTilesWithThePattern) {
    workspace.tiles.stamp.cells = {7};
    drag(Mode::Fill, {0, 0}, {0, 0});
    EXPECT_EQ(row(0), "7777");
    EXPECT_EQ(row(1), "7117");
    EXPECT_EQ(row(2), "2222");
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Tiles, theEraserClearsWhatItCrosses) {
    drag(Mode::Erase, {0, 2}, {2, 2});
    EXPECT_EQ(row(2), "0002");
}

TEST_F(Tiles, shiftDrawsALineFromTheLastStroke) {
    TileTool brush{Mode::Brush};
    workspace.tiles.stamp.cells = {9};
    drag(brush, {0, 0}, {0, 0});
    drag(brush, {3, 0}, {3, 0}, {.modifiers = {.shift = true}});
    EXPECT_EQ(row(0), "9999");
}

TEST_F(Tiles, aPickedBoxIsPaintedElsewhere) {
    TileTool pick{Mode::Pick};
    drag(pick, {2, 2}, {1, 1});
    EXPECT_EQ(workspace.tiles.stamp, (TileStamp{2, 2, {1, 1, 2, 2}}));
    EXPECT_EQ(pick.next(), "tool.brush");

    workspace.tiles.stamp = {};
    drag(Mode::Brush, {0, 2}, {0, 2}, {.secondary = true});
    EXPECT_EQ(workspace.tiles.stamp, (TileStamp{1, 1, {2}})) << "the right button picks in every mode";
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Tiles, theBrushPreviewsItsTiles) {
    workspace.tiles.stamp = {2, 1, {3, 4}};
    const TileTool tool{Mode::Brush};
    Overlay overlay;
    tool.draw(workspace.tools(), {.position = middleOf(1, 1)}, overlay);
    std::vector<TileCell> shown;
    for (const Overlay::Shape& shape : overlay.shapes()) {
        if (shape.kind != Overlay::Kind::Tile) continue;
        EXPECT_EQ(shape.from, (Vec2{16.0f + 16.0f * static_cast<float>(shown.size()), 16.0f}));
        shown.push_back(shape.cell);
    }
    EXPECT_EQ(shown, (std::vector<TileCell>{3, 4}));
}

TEST_F(Tiles, escapeCancelsAnUnfinishedRectangle) {
    TileTool tool{Mode::Rectangle};
    tool.press(workspace.tools(), {.position = middleOf(0, 0)});
    tool.drag(workspace.tools(), {.position = middleOf(2, 2)});
    EXPECT_TRUE(tool.cancel(workspace.tools()));
    tool.release(workspace.tools(), {.position = middleOf(2, 2)});
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Tiles, theTileSizeIsThatOfTheTilesetIfTheLayerHasNone) {
    Tileset tileset;
    tileset.tileWidth = 24;
    tileset.tileHeight = 8;
    tileset.count = 10;
    layer().tileset = workspace.assets.addTileset("wide", tileset);
    layer().tileSize = {};
    const ObjectId ground = named("ground");

    const CellPlace place = cellAt(workspace.document, ground, {50.0f, 17.0f});
    EXPECT_EQ(place, (CellPlace{2, 2}));
    const AABB box = boxOfCell(workspace.document, ground, {2, 1});
    EXPECT_EQ(box.min, (Vec2{48.0f, 8.0f}));
    EXPECT_EQ(box.max, (Vec2{72.0f, 16.0f}));
    EXPECT_EQ(boundsOf(workspace.document.world, workspace.document.find(ground)).max, (Vec2{96.0f, 24.0f}));
}

TEST_F(Tiles, aScaledLayerIsPaintedAtTheMousePosition) {
    workspace.document.world.get<Transform>(workspace.document.find(named("ground"))) =
        Transform{{100.0f, 50.0f}, 0.0f, {2.0f, 2.0f}};
    EXPECT_EQ(cellAt(workspace.document, named("ground"), {165.0f, 83.0f}), (CellPlace{2, 1}));
}

TEST_F(Tiles, theActiveLayerIsTheSelectedTheLastOrTheFirstSolidOne) {
    const Document& document = workspace.document;
    const ObjectId ground = named("ground");
    runAction(workspace, "edit.selectAll");
    workspace.document.selection.set({ground});
    runAction(workspace, "edit.duplicate");
    const ObjectId copy = document.selection.all().front();
    EXPECT_EQ(activeTileLayer(document, workspace.tiles), copy);
    workspace.document.selection.set(document.objects());
    workspace.document.selection.add(ground);
    EXPECT_TRUE(activeTileLayer(document, workspace.tiles)) << "one of those that are selected";
    for (const std::vector<ObjectId>& both : {std::vector{copy, ground}, std::vector{ground, copy}}) {
        workspace.document.selection.set(both);
        EXPECT_EQ(activeTileLayer(document, workspace.tiles), both.front());
    }
    workspace.document.selection.clear();
    EXPECT_EQ(activeTileLayer(document, workspace.tiles), ground);
    workspace.document.world.add<TileCollider>(document.find(copy));
    EXPECT_EQ(activeTileLayer(document, workspace.tiles), copy) << "what is solid comes before what is not";
    workspace.tiles.layer = ground;
    EXPECT_EQ(activeTileLayer(document, workspace.tiles), ground);
}

TEST(TileStamps, fourRotationsOrTwoFlipsAreTheIdentity) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        TileStamp stamp{static_cast<int>(random.below(3)) + 1, static_cast<int>(random.below(3)) + 1, {}};
        for (int i = 0; i < stamp.width * stamp.height; ++i) {
            const TileCell flips = random.below(8) * kTileFlipDiagonal;
            stamp.cells.push_back(random.below(4) == 0 ? 0
                                                       : cellOf(static_cast<int>(random.below(9)), flips));
        }
        EXPECT_EQ(flippedX(flippedX(stamp)), stamp);
        EXPECT_EQ(flippedY(flippedY(stamp)), stamp);
        EXPECT_EQ(turned(turned(turned(turned(stamp)))), stamp);
        EXPECT_EQ(turned(turned(stamp)), flippedX(flippedY(stamp)));
        EXPECT_EQ(turned(flippedX(stamp)), flippedY(turned(stamp)));
    }
}

TEST(TileStamps, aQuarterTurnMatchesTheDrawnTile) {
    // A diagonal flip followed by a horizontal one is a quarter turn: the left side becomes the top.
    EXPECT_EQ(turned({1, 1, {cellOf(3)}}).cells.front(), cellOf(3, kTileFlipDiagonal | kTileFlipX));
    EXPECT_EQ(turned({2, 1, {cellOf(1), cellOf(2)}}).height, 2);
}

TEST(TilePalettes, areLaidOutLikeTheImageOrInRowsOfEight) {
    Tileset sheet;
    sheet.image = "tiles.png";
    sheet.columns = 4;
    sheet.count = 10;
    const TilePalette palette = paletteOf(sheet);
    EXPECT_EQ(palette.rows, 3);
    EXPECT_EQ(palette.tileAt({1, 2}), 9);
    EXPECT_EQ(palette.tileAt({2, 2}), -1) << "the last row is not full";
    EXPECT_EQ(palette.tileAt({4, 0}), -1);
    EXPECT_EQ(palette.nearest({-5.0f, 900.0f}), (CellPlace{0, 2}));
    EXPECT_EQ(palette.stamp({2, 1}, {1, 0}), (TileStamp{2, 2, {cellOf(1), cellOf(2), cellOf(5), cellOf(6)}}));

    Tileset collection;
    collection.images = {{0, "a.png", {}, {}}, {11, "b.png", {}, {}}};
    EXPECT_EQ(paletteOf(collection).columns, 8);
    EXPECT_EQ(paletteOf(collection).rows, 2);
    EXPECT_EQ(paletteOf(Tileset{}).rows, 0);
}

}  // namespace
}  // namespace plumb::editor
