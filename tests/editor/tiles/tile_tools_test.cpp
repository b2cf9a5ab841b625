#include "editor/model/tools/tile_tools.hpp"

#include <set>

#include "editor/model/actions.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/cell_shapes.hpp"
#include "editor/model/tiles/tile_clipboard.hpp"
#include "tests/editor/support/tile_scene.hpp"

namespace plumb::editor {
namespace {

class TileTools : public TileScene {
protected:
    TileTools() : empty_{workspace.text()} { runAction(workspace, "tool.brush"); }
    [[nodiscard]] std::string row(int y) const {
        const TileGrid& grid = *gridOf(workspace.document, layer());
        std::string text;
        for (int x = 0; x < grid.width(); ++x) text += std::to_string(grid.at(x, y));
        return text;
    }
    void put(CellPlace at, TileCell cell) {
        const TileLayer& tiles = workspace.document.world.get<TileLayer>(workspace.document.find(layer()));
        workspace.document.world.tiles().edit(tiles.cells)->set(at.x, at.y, cell);
    }
    void expectOneStep() {
        EXPECT_EQ(workspace.undo.size(), 1u);
        workspace.undo.undo();
        EXPECT_EQ(workspace.text(), empty_);
        workspace.undo.redo();
    }
    bool press(Key key, Modifiers modifiers = {}) {
        return runShortcut(workspace, {.kind = EventKind::KeyDown, .key = key, .modifiers = modifiers});
    }
    std::string empty_;
};

TEST_F(TileTools, aLineHasNoHolesAndIsOneStep) {
    workspace.tiles.stamp.cells = {3};
    EXPECT_TRUE(press(Key::L));
    stroke({0, 0}, {7, 3});
    for (int x = 0; x < 8; ++x) {
        int painted = 0;
        for (int y = 0; y < 4; ++y) painted += gridOf(workspace.document, layer())->at(x, y) == 3 ? 1 : 0;
        EXPECT_EQ(painted, 1) << "column " << x;
    }
    expectOneStep();
}

TEST_F(TileTools, anEllipseIsRoundAndShiftMakesACircle) {
    workspace.tiles.stamp.cells = {1};
    EXPECT_TRUE(press(Key::U, {.shift = true}));
    stroke({0, 0}, {4, 3});
    EXPECT_EQ(row(0), "01110000");
    EXPECT_EQ(row(1), "11111000");
    EXPECT_EQ(row(2), "11111000");
    EXPECT_EQ(row(3), "01110000");
    workspace.undo.undo();
    stroke({0, 0}, {1, 3}, {.modifiers = {.shift = true}});
    EXPECT_EQ(row(0), "01100000");
    EXPECT_EQ(row(1), "11110000");
}

TEST_F(TileTools, controlAndShiftPaintARectangleWithTheBrush) {
    workspace.tiles.stamp.cells = {2};
    stroke({1, 1}, {3, 2}, {.modifiers = {.shift = true, .control = true}});
    EXPECT_EQ(row(0), "00000000");
    EXPECT_EQ(row(1), "02220000");
    EXPECT_EQ(row(2), "02220000");
    expectOneStep();
}

TEST_F(TileTools, fillingWithShiftReachesAllEqualCells) {
    for (const int x : {0, 3, 7}) put({x, 1}, 5);
    workspace.tiles.stamp.cells = {6};
    EXPECT_TRUE(press(Key::G));
    stroke({3, 1}, {3, 1}, {.modifiers = {.shift = true}});
    EXPECT_EQ(row(1), "60060006");
}

TEST_F(TileTools, theFillOfTheBucketIsPreviewed) {
    for (const int x : {0, 3, 7}) put({x, 1}, 5);
    for (int x = 0; x < 8; ++x) put({x, 2}, 4);
    workspace.tiles.stamp.cells = {6};
    EXPECT_TRUE(press(Key::G));
    const auto shown = [&](Modifiers modifiers) {
        Overlay overlay;
        workspace.tool().draw(workspace.tools(), {.position = middleOf(1, 0), .modifiers = modifiers},
                              overlay);
        std::set<std::pair<int, int>> tiles;
        for (const Overlay::Shape& shape : overlay.shapes()) {
            if (shape.kind != Overlay::Kind::Tile) continue;
            EXPECT_EQ(shape.cell, 6u);
            tiles.insert({static_cast<int>(shape.from.x) / 16, static_cast<int>(shape.from.y) / 16});
        }
        return tiles;
    };
    const auto changed = [&] {
        std::set<std::pair<int, int>> tiles;
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 8; ++x) {
                if (gridOf(workspace.document, layer())->at(x, y) == 6) tiles.insert({x, y});
            }
        }
        return tiles;
    };
    for (const Modifiers modifiers : {Modifiers{}, Modifiers{.shift = true}}) {
        const auto before = shown(modifiers);
        EXPECT_EQ(before.size(), modifiers.shift ? 21u : 13u) << "the row below the others is cut off";
        stroke({1, 0}, {1, 0}, {.modifiers = modifiers});
        EXPECT_EQ(changed(), before);
        workspace.undo.undo();
    }
    workspace.tiles.selected.set({{1, 0}, {2, 2}});
    EXPECT_EQ(shown({}), (std::set<std::pair<int, int>>{{1, 0}, {2, 2}}));
}

TEST_F(TileTools, inAHugeAreaOnlyTheFillNearTheMouseIsPreviewed) {
    useTileset(terrainSet(TerrainMode::Corners, 1));
    World& world = workspace.document.world;
    world.get<TileLayer>(workspace.document.find(layer())).cells = world.tiles().add(TileGrid{16384, 16384});
    workspace.tiles.stamp.cells = {6};
    EXPECT_TRUE(press(Key::G));
    for (const Modifiers modifiers : {Modifiers{}, Modifiers{.shift = true}}) {
        Overlay overlay;
        workspace.tool().draw(workspace.tools(), {.position = middleOf(8000, 8000), .modifiers = modifiers},
                              overlay);
        std::size_t tiles = 0;
        std::string words;
        for (const Overlay::Shape& shape : overlay.shapes()) {
            tiles += shape.kind == Overlay::Kind::Tile ? 1 : 0;
            words += shape.text;
        }
        EXPECT_GT(tiles, 4000u);
        EXPECT_LT(tiles, 4200u);
        EXPECT_EQ(words, modifiers.shift ? "all equal cells" : "more than 4096 cells");
    }
}

TEST_F(TileTools, theRightButtonErasesIfThePreferenceIsSet) {
    put({2, 2}, 5);
    put({3, 2}, 5);
    stroke({2, 2}, {3, 2}, {.secondary = true});
    EXPECT_EQ(row(2), "00550000");
    EXPECT_EQ(workspace.tiles.stamp, (TileStamp{2, 1, {5, 5}}));
    runAction(workspace, "tiles.rightErases");
    stroke({2, 2}, {3, 2}, {.secondary = true});
    EXPECT_EQ(row(2), "00000000");
}

TEST_F(TileTools, selectedCellsMoveWithTheirTilesAndUndoRestoresThem) {
    put({1, 1}, 4);
    put({2, 1}, 5);
    EXPECT_TRUE(press(Key::M));
    stroke({1, 1}, {2, 1});
    EXPECT_EQ(workspace.tiles.selected.all().size(), 2u);
    EXPECT_EQ(workspace.undo.size(), 0u) << "selecting is no edit";
    stroke({2, 1}, {5, 3});
    EXPECT_EQ(row(1), "00000000");
    EXPECT_EQ(row(3), "00004500");
    EXPECT_TRUE(workspace.tiles.selected.has({4, 3}));
    stroke({4, 3}, {4, 0}, {.modifiers = {.alt = true}});
    EXPECT_EQ(row(0), "00004500");
    EXPECT_EQ(row(3), "00004500") << "Alt copies";
    workspace.undo.undo();
    workspace.undo.undo();
    EXPECT_EQ(row(1), "04500000");
}

TEST_F(TileTools, anOverlappingMoveLosesNoTiles) {
    for (int x = 0; x < 4; ++x) put({x, 0}, static_cast<TileCell>(x + 1));
    press(Key::M);
    stroke({0, 0}, {3, 0});
    stroke({0, 0}, {1, 0});
    EXPECT_EQ(row(0), "01234000");
}

TEST_F(TileTools, shiftAddsToTheSelectionAndControlTakesAway) {
    press(Key::M);
    stroke({0, 0}, {1, 0});
    stroke({4, 2}, {4, 2}, {.modifiers = {.shift = true}});
    EXPECT_EQ(workspace.tiles.selected.all().size(), 3u);
    stroke({0, 0}, {0, 0}, {.modifiers = {.control = true}});
    EXPECT_FALSE(workspace.tiles.selected.has({0, 0}));
    press(Key::Escape);
    EXPECT_TRUE(workspace.tiles.selected.empty());
}

TEST_F(TileTools, selectedTilesAreCopiedCutClearedAndPainted) {
    put({1, 1}, 4);
    put({2, 2}, 5);
    press(Key::M);
    stroke({1, 1}, {2, 2});
    EXPECT_TRUE(press(Key::C, {.control = true}));
    EXPECT_EQ(tilesFromText(workspace.clipboard), (TileStamp{2, 2, {4, 0, 0, 5}}));
    EXPECT_TRUE(press(Key::X, {.control = true}));
    EXPECT_EQ(row(1), "00000000");
    EXPECT_TRUE(press(Key::V, {.control = true}));
    EXPECT_EQ(workspace.tool().next(), "");
    stroke({5, 0}, {5, 0});
    EXPECT_EQ(row(0), "00000400");
    EXPECT_EQ(row(1), "00000050");

    press(Key::M);
    stroke({5, 0}, {6, 1});
    EXPECT_TRUE(press(Key::Delete));
    EXPECT_EQ(row(0), "00000000");
    EXPECT_TRUE(workspace.document.find(layer())) << "the tiles are deleted, not their layer";
}

TEST_F(TileTools, entitiesAreStillDeletedWhileNoTilesAreSelected) {
    workspace.document.selection.set({named("crate")});
    EXPECT_TRUE(press(Key::Delete));
    EXPECT_FALSE(named("crate"));
}

TEST_F(TileTools, sameTilesAreSelectedByOneClick) {
    for (const int x : {0, 3, 7}) put({x, 1}, 5);
    put({4, 1}, 6);
    EXPECT_TRUE(press(Key::S));
    stroke({3, 1}, {3, 1});
    EXPECT_EQ(workspace.tiles.selected.all(), (std::vector<CellPlace>{{0, 1}, {3, 1}, {7, 1}}));
    workspace.tiles.stamp.cells = {9};
    press(Key::G);
    stroke({0, 1}, {0, 1});
    EXPECT_EQ(row(1), "90096009") << "the bucket fills what is selected";
}

TEST_F(TileTools, nineStampsAreStoredAndRestored) {
    workspace.tiles.stamp = {2, 1, {7, 8}};
    EXPECT_TRUE(press(Key::Digit3, {.control = true}));
    workspace.tiles.stamp = {};
    press(Key::E);
    EXPECT_TRUE(press(Key::Digit3));
    EXPECT_EQ(workspace.tiles.stamp, (TileStamp{2, 1, {7, 8}}));
    EXPECT_EQ(toolTable()[workspace.toolIndex()].action, "tool.brush");
    press(Key::Digit4);
    EXPECT_NE(workspace.notice.find("Ctrl+4"), std::string::npos) << "an empty place says how to fill it";
}

TEST_F(TileTools, stampsFlipAndTurnByTheirKeys) {
    workspace.tiles.stamp = {2, 1, {cellOf(1), cellOf(2)}};
    const TileStamp before = workspace.tiles.stamp;
    press(Key::X);
    EXPECT_EQ(workspace.tiles.stamp, flippedX(before));
    press(Key::X), press(Key::Y);
    EXPECT_EQ(workspace.tiles.stamp, flippedY(before));
    press(Key::Y), press(Key::Z);
    EXPECT_EQ(workspace.tiles.stamp, turned(before));
    press(Key::Z, {.shift = true});
    EXPECT_EQ(workspace.tiles.stamp, before);
}

TEST_F(TileTools, randomTilesFollowTheirWeightsAndAreNeverEmpty) {
    Tileset set = terrainSet(TerrainMode::Blob, 1);
    Tile never;
    never.id = 2;
    never.probability = 0.0f;
    set.tiles = {never};
    useTileset(set);
    workspace.tiles.stamp = {2, 2, {cellOf(1), cellOf(2), 0, cellOf(3)}};
    press(Key::D);
    press(Key::U);
    stroke({0, 0}, {7, 3});
    std::set<TileCell> seen;
    for (int i = 0; i < 32; ++i) seen.insert(gridOf(workspace.document, layer())->at(i % 8, i / 8));
    EXPECT_EQ(seen, (std::set<TileCell>{cellOf(1), cellOf(3)}));
}

TEST_F(TileTools, aLockedLayerIsNotPaintedOn) {
    EXPECT_TRUE(press(Key::L, {.control = true}));
    workspace.tiles.stamp.cells = {1};
    stroke({1, 1}, {3, 1});
    EXPECT_EQ(workspace.undo.size(), 0u);
    press(Key::L, {.control = true});
    stroke({1, 1}, {3, 1});
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(TileTools, aStrokeGoingOverItselfTakesMemoryOnce) {
    workspace.tiles.stamp.cells = {1};
    Pointer pointer{.position = middleOf(0, 0)};
    workspace.tool().press(workspace.tools(), pointer);
    for (int i = 0; i < 50; ++i) {
        workspace.tiles.stamp.cells = {static_cast<TileCell>(i % 7 + 1)};
        pointer.position = middleOf(i % 8, 0);
        workspace.tool().drag(workspace.tools(), pointer);
    }
    workspace.tool().release(workspace.tools(), pointer);
    const std::string painted = row(0);
    workspace.undo.undo();
    EXPECT_EQ(row(0), "00000000");
    workspace.undo.redo();
    EXPECT_EQ(row(0), painted);
}

TEST_F(TileTools, layersAreAddedChosenRaisedHiddenAndShownAlone) {
    runAction(workspace, "layer.add");
    const ObjectId above = workspace.tiles.layer;
    ASSERT_NE(above, layer());
    EXPECT_EQ(tileLayers(workspace.document), (std::vector{above, layer()}));
    EXPECT_TRUE(press(Key::PageDown, {.control = true}));
    EXPECT_EQ(activeTileLayer(workspace.document, workspace.tiles), layer());
    press(Key::PageUp, {.shift = true, .control = true});
    EXPECT_EQ(tileLayers(workspace.document).front(), layer());
    EXPECT_TRUE(press(Key::H));
    EXPECT_TRUE(workspace.document.view.hides(above));
    press(Key::H);
    EXPECT_FALSE(workspace.document.view.hides(above));
    press(Key::H, {.control = true});
    EXPECT_TRUE(workspace.document.view.hides(layer()));
    while (workspace.undo.undo()) {
    }
    EXPECT_EQ(workspace.text(), empty_);
}

TEST_F(TileTools, aLayerExplainsWhyNoTileIsVisible) {
    const auto words = [&] {
        Overlay overlay;
        workspace.tool().draw(workspace.tools(), {.position = middleOf(1, 1)}, overlay);
        std::string all;
        for (const Overlay::Shape& shape : overlay.shapes()) all += shape.text;
        return all;
    };
    EXPECT_EQ(words(), "this layer has no tileset; select one in the Inspector");
    useTileset(terrainSet(TerrainMode::Corners, 1));
    EXPECT_EQ(words(), "");
    workspace.document.view.setLocked(layer(), true);
    EXPECT_EQ(words(), "this layer is locked");
    workspace.document.view.setLocked(layer(), false);
    workspace.document.view.setHidden(layer(), true);
    EXPECT_EQ(words(), "this layer is hidden");
}

TEST(CellShapes, connectedCellsStopAtOtherTilesAndAtTheBorder) {
    TileGrid grid{40, 40};
    for (int y = 0; y < 40; ++y) grid.set(20, y, 1);
    EXPECT_EQ(connectedCells(grid, nullptr, {0, 0}).size(), 800u);
    EXPECT_EQ(connectedCells(grid, nullptr, {20, 5}).size(), 40u);
    EXPECT_TRUE(connectedCells(grid, nullptr, {40, 0}).empty());
    EXPECT_EQ(equalCells(grid, nullptr, {0, 0}).size(), 1560u);
}

}  // namespace
}  // namespace plumb::editor
