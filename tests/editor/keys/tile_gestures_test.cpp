// Mouse gestures of the tile tools in the real window; each tool is selected by its key.

#include "tests/editor/keys/desk.hpp"
#include "tests/editor/support/terrain_set.hpp"

namespace plumb::editor::ui {
namespace {

/// The layer has the rows 0000, 0110 and 2222; the brush paints tile 3.
class TileGestures : public Desk {
protected:
    TileGestures() {
        takeBrush();
        workspace.tiles.stamp = {1, 1, {3}};
    }
    [[nodiscard]] Vec2 at(int x, int y) const { return onScreen(cell(x, y)); }
    void stroke(CellPlace from, CellPlace to, MouseButton button = MouseButton::Left) {
        dragWith(button, at(from.x, from.y), at(to.x, to.y));
    }
    [[nodiscard]] std::string rows() const { return row(0) + " " + row(1) + " " + row(2); }
    void expectOneStep() {
        EXPECT_EQ(workspace.undo.size(), 1u);
        press("Ctrl+Z");
        EXPECT_EQ(workspace.text(), kSceneText);
    }
};

TEST_F(TileGestures, theBrushPaintsWhereItIsDragged) {
    press("B");
    stroke({0, 0}, {3, 0});
    EXPECT_EQ(rows(), "3333 0110 2222");
    expectOneStep();
}

TEST_F(TileGestures, shiftDrawsALineFromTheLastStroke) {
    hands.clickAt(at(0, 0));
    hands.held = {.shift = true};
    hands.clickAt(at(3, 0));
    EXPECT_EQ(rows(), "3333 0110 2222");
    EXPECT_EQ(workspace.undo.size(), 2u);
}

TEST_F(TileGestures, controlAndShiftMakeABox) {
    hands.held = {.shift = true, .control = true};
    stroke({1, 0}, {2, 2});
    EXPECT_EQ(rows(), "0330 0330 2332");
    hands.held = {};
    expectOneStep();
}

TEST_F(TileGestures, linesRectanglesAndEllipsesAreDrawnOnMouseRelease) {
    press("L");
    stroke({0, 1}, {3, 1});
    EXPECT_EQ(rows(), "0000 3333 2222");
    press("U");
    stroke({3, 2}, {0, 1});
    EXPECT_EQ(rows(), "0000 3333 3333");
    press("Ctrl+Z"), press("Ctrl+Z");
    EXPECT_EQ(workspace.text(), kSceneText);
    press("Shift+U");
    stroke({0, 0}, {3, 2});
    EXPECT_EQ(rows(), "0330 3333 2332");
    expectOneStep();
}

TEST_F(TileGestures, theBucketFillsConnectedCells) {
    press("G");
    hands.clickAt(at(0, 0));
    EXPECT_EQ(rows(), "3333 3113 2222");
    expectOneStep();
}

TEST_F(TileGestures, theEraserClears) {
    press("E");
    stroke({0, 2}, {2, 2});
    EXPECT_EQ(rows(), "0000 0110 0002");
    expectOneStep();
}

TEST_F(TileGestures, tilesArePickedByTheirToolByAltAndByTheRightButton) {
    press("I");
    hands.clickAt(at(0, 2));
    EXPECT_EQ(workspace.tiles.stamp, (TileStamp{1, 1, {2}}));
    EXPECT_EQ(toolInHand(), "tool.brush") << "and is painted with";
    hands.held = {.alt = true};
    hands.clickAt(at(1, 1));
    EXPECT_EQ(workspace.tiles.stamp, (TileStamp{1, 1, {1}}));
    hands.held = {};
    stroke({1, 1}, {2, 2}, MouseButton::Right);
    EXPECT_EQ(workspace.tiles.stamp, (TileStamp{2, 2, {1, 1, 2, 2}})) << "a drag takes a stamp";
    EXPECT_EQ(workspace.text(), kSceneText) << "nothing was painted";
    EXPECT_FALSE(shown("Viewport/menu/Duplicate"));
}

TEST_F(TileGestures, theRightButtonErasesIfTheUserPrefersThat) {
    workspace.tiles.rightErases = true;
    stroke({0, 2}, {3, 2}, MouseButton::Right);
    EXPECT_EQ(rows(), "0000 0110 0000");
    expectOneStep();
}

TEST_F(TileGestures, cellsAreSelectedAndMoved) {
    press("M");
    stroke({1, 1}, {2, 1});
    EXPECT_EQ(workspace.undo.size(), 0u) << "selecting is no edit";
    stroke({1, 1}, {2, 0});
    EXPECT_EQ(rows(), "0011 0000 2222");
    expectOneStep();
}

TEST_F(TileGestures, equalTilesAreSelectedByAClick) {
    press("S");
    hands.clickAt(at(1, 2));
    EXPECT_EQ(workspace.tiles.selected.all().size(), 4u);
    press("Delete");
    EXPECT_EQ(rows(), "0000 0110 0000");
}

TEST_F(TileGestures, terrainIsPaintedWithItsBorders) {
    putFile("assets/ground.tileset.json", writeTileset(terrainSet(TerrainMode::Blob, 1)));
    World& world = workspace.document.world;
    world.get<TileLayer>(workspace.document.find(named("ground"))).tileset =
        workspace.assets.loadTileset("assets/ground.tileset.json");
    press("T");
    stroke({0, 0}, {1, 0});
    const auto& layer = std::as_const(world).get<TileLayer>(workspace.document.find(named("ground")));
    const TileGrid* terrain = world.tiles().find(layer.terrain);
    ASSERT_NE(terrain, nullptr);
    EXPECT_EQ(terrain->at(0, 0), 1u);
    EXPECT_EQ(terrain->at(1, 0), 1u);
    EXPECT_EQ(terrain->at(3, 0), 0u);
    EXPECT_NE(grid().at(0, 0), 0u) << "the tiles follow";
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(TileGestures, aLayerIsLookedAtThroughItsFields) {
    const auto drag = [&](std::string_view widget, Vec2 place) {
        const AABB box = window.widgets().find(widget)->box;
        const Vec2 from = box.min + scaled(box.size(), place);
        hands.drag(from, from + Vec2{40.0f, 0.0f});
    };
    drag("Tiles/layer/parallax", {0.25f, 0.5f});
    EXPECT_EQ(valueOf("Tiles/layer/parallax").substr(0, 2), "1.") << valueOf("Tiles/layer/parallax");
    drag("Tiles/layer/offset", {0.25f, 0.5f});
    EXPECT_GT(positionOf(named("ground")).x, 10.0f);
    EXPECT_EQ(workspace.undo.size(), 2u) << "one step for each drag";
    press("Ctrl+Z"), press("Ctrl+Z");
    EXPECT_EQ(workspace.text(), kSceneText);
}

}  // namespace
}  // namespace plumb::editor::ui
