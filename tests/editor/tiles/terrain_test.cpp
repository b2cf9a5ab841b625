#include <algorithm>

#include "assets/autotile.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/tile_layer_edit.hpp"
#include "editor/model/tools/tile_tools.hpp"
#include "tests/editor/support/tile_scene.hpp"

namespace plumb::editor {
namespace {

/// The scene's tile layer with a tileset that has one terrain.
class TerrainPainting : public TileScene {
protected:
    TerrainPainting() {
        useTileset(terrainSet(TerrainMode::Blob, 1));
        runAction(workspace, "tool.terrain");
    }
    [[nodiscard]] const TileGrid& grid() const { return *gridOf(workspace.document, layer()); }
    /// Returns the cell of the tile with a mask: tiles are numbered in the order of the masks.
    [[nodiscard]] static TileCell cellOfMask(int mask) {
        const std::vector<std::uint8_t> masks = masksOf(TerrainMode::Blob);
        return cellOf(static_cast<int>(std::find(masks.begin(), masks.end(), mask) - masks.begin()));
    }
};

TEST_F(TerrainPainting, aStrokeWithItsBordersIsOneStepAndUndoRestoresTheFile) {
    const std::string before = workspace.text();
    stroke({2, 2}, {4, 2});
    EXPECT_EQ(grid().at(2, 2), cellOfMask(Neighbour::kRight));
    EXPECT_EQ(grid().at(3, 2), cellOfMask(Neighbour::kLeft | Neighbour::kRight));
    EXPECT_EQ(grid().at(4, 2), cellOfMask(Neighbour::kLeft));
    ASSERT_EQ(workspace.undo.size(), 1u);
    const std::string after = workspace.text();
    EXPECT_NE(after.find("\"terrain\""), std::string::npos);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
    workspace.undo.redo();
    EXPECT_EQ(workspace.text(), after);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
}

TEST_F(TerrainPainting, theEraserRemovesTerrainAndUpdatesTheBordersOfItsNeighbours) {
    stroke({2, 2}, {4, 2});
    runAction(workspace, "tool.erase");
    stroke({3, 2}, {3, 2});
    EXPECT_EQ(grid().at(3, 2), 0u);
    EXPECT_EQ(grid().at(2, 2), cellOfMask(0));
    EXPECT_EQ(terrainOf(workspace.document, layer())->at(3, 2), 0u);
}

TEST_F(TerrainPainting, aTilePaintedOverTerrainStaysUntilTheTerrainThereChanges) {
    stroke({1, 1}, {5, 1});
    runAction(workspace, "tool.brush");
    workspace.tiles.stamp.cells = {cellOf(77)};
    stroke({3, 1}, {3, 1});
    EXPECT_EQ(grid().at(2, 1), cellOfMask(Neighbour::kLeft | Neighbour::kRight))
        << "its neighbours stay as they are";
    runAction(workspace, "tool.terrain");
    stroke({6, 1}, {6, 1});
    EXPECT_EQ(grid().at(3, 1), cellOf(77)) << "far strokes leave it";
    stroke({3, 2}, {3, 2});
    EXPECT_EQ(grid().at(3, 1), cellOfMask(Neighbour::kLeft | Neighbour::kRight | Neighbour::kDown));
}

TEST_F(TerrainPainting, allTilesOfATerrainCanBeUpdated) {
    stroke({1, 1}, {3, 1});
    runAction(workspace, "tool.brush");
    workspace.tiles.stamp.cells = {cellOf(77)};
    stroke({2, 1}, {2, 1});
    runAction(workspace, "tiles.retile");
    EXPECT_EQ(grid().at(2, 1), cellOfMask(Neighbour::kLeft | Neighbour::kRight));
}

TEST_F(TerrainPainting, everyShapeToolPaintsTheActiveTerrain) {
    runAction(workspace, "tool.rectangle");
    EXPECT_TRUE(workspace.tiles.activeTerrain) << "the rectangle keeps what was in the hand";
    stroke({1, 1}, {3, 3});
    EXPECT_EQ(grid().at(2, 2), cellOfMask(Neighbour::kAll));
    runAction(workspace, "tool.fill");
    stroke({6, 3}, {6, 3});
    EXPECT_EQ(grid().at(7, 0), cellOfMask(Neighbour::kAll));
    runAction(workspace, "tool.brush");
    EXPECT_FALSE(workspace.tiles.activeTerrain);
}

TEST_F(TerrainPainting, thePreviewShowsTheResultingBorders) {
    stroke({2, 2}, {2, 2});
    Overlay overlay;
    workspace.tool().draw(workspace.tools(), {.position = middleOf(3, 2)}, overlay);
    std::vector<TileCell> shown;
    for (const Overlay::Shape& shape : overlay.shapes()) {
        if (shape.kind == Overlay::Kind::Tile) shown.push_back(shape.cell);
    }
    EXPECT_EQ(shown, (std::vector<TileCell>{cellOfMask(Neighbour::kRight), cellOfMask(Neighbour::kLeft)}));
}

TEST_F(TerrainPainting, pickingACellOfTerrainActivatesThatTerrain) {
    useTileset(terrainSet(TerrainMode::Blob, 2));
    workspace.tiles.terrain = 2;
    stroke({2, 2}, {2, 2});
    workspace.tiles.terrain = 1;
    stroke({2, 2}, {2, 2}, {.secondary = true});
    EXPECT_EQ(workspace.tiles.terrain, 2);
    EXPECT_TRUE(workspace.tiles.activeTerrain);
}

TEST_F(TerrainPainting, withoutATerrainTheToolSaysWhereToMakeOne) {
    useTileset(Tileset{});
    runAction(workspace, "tool.terrain");
    EXPECT_NE(workspace.notice.find("no terrain yet"), std::string::npos);
    stroke({2, 2}, {3, 2});
    EXPECT_EQ(workspace.undo.size(), 0u);
}

}  // namespace
}  // namespace plumb::editor
