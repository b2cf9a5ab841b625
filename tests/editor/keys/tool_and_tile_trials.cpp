#include <array>
#include <utility>
#include <vector>

#include "editor/model/tiles/tile_clipboard.hpp"
#include "tests/editor/keys/desk.hpp"

namespace plumb::editor::ui {
namespace {

/// Expects that the keys select the tool of their action. The behaviour of the tools has tests of its own.
void takes(KeyTrials& at) {
    at.workspace.useTool(at.toolInHand() == "tool.select" ? "tool.pick" : "tool.select");
    at.press();
    EXPECT_EQ(at.toolInHand(), at.GetParam().action);
}
/// Expects that the keys select the tool of their action while the brush is active.
void takesWhilePainting(KeyTrials& at) {
    at.takeBrush();
    at.press();
    EXPECT_EQ(at.toolInHand(), at.GetParam().action);
}
void takesFromEntities(KeyTrials& at) {
    at.press();
    EXPECT_EQ(at.toolInHand(), at.GetParam().action);
}

/// Expects that the keys apply `Change` to a stamp of two tiles.
template <TileStamp (*Change)(const TileStamp&)>
void changesStamp(KeyTrials& at) {
    at.takeBrush();
    const TileStamp before{2, 1, {cellOf(1), cellOf(2)}};
    at.workspace.tiles.stamp = before;
    at.press();
    EXPECT_EQ(at.workspace.tiles.stamp, Change(before));
    EXPECT_NE(at.workspace.tiles.stamp, before);
}

/// Selects the two middle tiles of the layer by a drag with the select tool (M).
void selectMiddle(KeyTrials& at) {
    at.takeBrush();
    at.press("M");
    at.hands.drag(at.onScreen(Desk::cell(1, 1)), at.onScreen(Desk::cell(2, 1)));
    ASSERT_EQ(at.workspace.tiles.selected.all().size(), 2u);
    ASSERT_EQ(at.row(1), "0110");
}

/// Expects that the keys move the selected tiles by one cell, and that repeated presses are one undo step.
template <int X, int Y>
void movesTiles(KeyTrials& at) {
    selectMiddle(at);
    at.press();
    EXPECT_EQ(at.grid().at(X < 0 ? 0 : X > 0 ? 3 : 1, 1 + Y), 1u);
    EXPECT_TRUE(at.workspace.tiles.selected.has({1 + X, 1 + Y}));
    at.press(), at.press();
    EXPECT_EQ(at.workspace.undo.size(), 1u) << "a run of taps is one step";
    at.press("Ctrl+Z");
    EXPECT_EQ(at.workspace.text(), kSceneText);
}

void clears(KeyTrials& at) {
    selectMiddle(at);
    at.press();
    EXPECT_EQ(at.row(1), "0000");
    EXPECT_EQ(at.count("ground"), 1) << "the tiles, not their layer";
}

/// Adds a second layer above the first one, which becomes the active layer.
ObjectId addLayer(KeyTrials& at) {
    at.takeBrush();
    runAction(at.workspace, "layer.add");
    at.hands.rest(2);
    return at.workspace.tiles.layer;
}
ObjectId inHand(KeyTrials& at) { return activeTileLayer(at.workspace.document, at.workspace.tiles); }

template <int Slot>
void keeps(KeyTrials& at) {
    at.takeBrush();
    at.workspace.tiles.stamp = {2, 1, {cellOf(5), cellOf(6)}};
    at.press();
    EXPECT_EQ(at.workspace.tiles.kept[Slot], at.workspace.tiles.stamp);
}
template <int Slot>
void recalls(KeyTrials& at) {
    at.takeBrush();
    const TileStamp kept{2, 1, {cellOf(5), cellOf(6)}};
    at.workspace.tiles.kept[Slot] = kept;
    at.press();
    EXPECT_EQ(at.workspace.tiles.stamp, kept);
    EXPECT_EQ(at.toolInHand(), "tool.brush");
}

const std::vector<KeyTrial> kTrials{
    {"Q", "tool.select",
     [](KeyTrials& at) {
         at.workspace.useTool("tool.move"), at.press();
         EXPECT_EQ(at.toolInHand(), "tool.select");
     }},
    {"W", "tool.move", takes},
    {"E", "tool.rotate", takesFromEntities},
    {"R", "tool.scale", takes},
    {"C", "tool.shape", takes},
    {"B", "tool.brush", takes},
    {"T", "tool.terrain", takes},
    {"L", "tool.line", takes},
    {"U", "tool.rectangle", takes},
    {"Shift+U", "tool.ellipse", takes},
    {"G", "tool.fill", takes},
    {"E", "tool.erase", takesWhilePainting},
    {"I", "tool.pick", takesFromEntities},
    {"M", "tool.moveTiles", takes},
    {"S", "tool.same", takesWhilePainting},
    {"X", "tiles.flipX", changesStamp<flippedX>},
    {"Y", "tiles.flipY", changesStamp<flippedY>},
    {"Z", "tiles.turn", changesStamp<turned>},
    {"Shift+Z", "tiles.turnBack", changesStamp<turnedBack>},
    {"D", "tiles.random",
     [](KeyTrials& at) {
         at.takeBrush();
         at.press();
         EXPECT_EQ(at.valueOf("Tiles/Random"), "on");
         at.press();
         EXPECT_EQ(at.valueOf("Tiles/Random"), "off");
     }},
    {"Ctrl+X", "tiles.cut",
     [](KeyTrials& at) {
         selectMiddle(at);
         at.press();
         EXPECT_EQ(at.row(1), "0000");
         EXPECT_EQ(tilesFromText(at.workspace.clipboard), (TileStamp{2, 1, {1, 1}}));
         EXPECT_EQ(at.count("ground"), 1) << "the tiles, not their layer";
     }},
    {"Ctrl+C", "tiles.copy",
     [](KeyTrials& at) {
         selectMiddle(at);
         at.press();
         EXPECT_EQ(tilesFromText(at.workspace.clipboard), (TileStamp{2, 1, {1, 1}}));
         EXPECT_EQ(at.workspace.text(), kSceneText);
     }},
    {"Ctrl+V", "tiles.paste",
     [](KeyTrials& at) {
         // paste from one layer into another
         selectMiddle(at);
         at.press("Ctrl+C");
         runAction(at.workspace, "layer.add");
         at.press("Ctrl+V");
         EXPECT_EQ(at.toolInHand(), "tool.brush");
         at.hands.clickAt(at.onScreen(Desk::cell(0, 0)));
         EXPECT_EQ(at.row(0), "1100");
     }},
    {"Delete", "tiles.clear", clears},
    {"Backspace", "tiles.clear", clears},
    {"Ctrl+A", "tiles.selectAll",
     [](KeyTrials& at) {
         at.takeBrush();
         at.press();
         EXPECT_EQ(at.workspace.tiles.selected.all().size(), 6u) << "all that are not empty";
     }},
    {"Left", "tiles.left", movesTiles<-1, 0>},
    {"Right", "tiles.right", movesTiles<1, 0>},
    {"Up", "tiles.up", movesTiles<0, -1>},
    {"Down", "tiles.down", movesTiles<0, 1>},
    {"K", "tiles.collision",
     [](KeyTrials& at) {
         const bool before = at.workspace.shows("collision");
         at.press();
         EXPECT_NE(at.workspace.shows("collision"), before);
         EXPECT_EQ(at.valueOf("Overlay/collision"), before ? "off" : "on");
     }},
    {"Ctrl+PageUp", "layer.above",
     [](KeyTrials& at) {
         const ObjectId above = addLayer(at);
         at.workspace.tiles.layer = at.named("ground");
         at.workspace.document.selection.set({at.named("ground")});
         at.press();
         EXPECT_EQ(inHand(at), above);
     }},
    {"Ctrl+PageDown", "layer.below",
     [](KeyTrials& at) {
         addLayer(at);
         at.press();
         EXPECT_EQ(inHand(at), at.named("ground"));
     }},
    {"Ctrl+Shift+PageUp", "layer.raise",
     [](KeyTrials& at) {
         addLayer(at);
         at.workspace.document.selection.set({at.named("ground")});
         at.press();
         EXPECT_EQ(tileLayers(at.workspace.document).front(), at.named("ground"));
     }},
    {"Ctrl+Shift+PageDown", "layer.lower",
     [](KeyTrials& at) {
         const ObjectId above = addLayer(at);
         ASSERT_EQ(tileLayers(at.workspace.document).front(), above);
         at.press();
         EXPECT_EQ(tileLayers(at.workspace.document).back(), above);
     }},
    {"H", "layer.solo",
     [](KeyTrials& at) {
         const ObjectId above = addLayer(at);
         at.press();
         EXPECT_TRUE(at.workspace.document.view.hides(at.named("ground")));
         EXPECT_FALSE(at.workspace.document.view.hides(above));
         at.press();
         EXPECT_FALSE(at.workspace.document.view.hides(at.named("ground")));
     }},
    {"Ctrl+H", "layer.hide",
     [](KeyTrials& at) {
         at.takeBrush();
         at.press();
         EXPECT_TRUE(at.workspace.document.view.isHidden(at.named("ground")));
     }},
    {"Ctrl+L", "layer.lock",
     [](KeyTrials& at) {
         at.takeBrush();
         at.press();
         EXPECT_TRUE(at.workspace.document.view.locks(at.named("ground")));
         at.hands.clickAt(at.onScreen(Desk::cell(0, 0)));
         EXPECT_EQ(at.row(0), "0000") << "nothing is painted on it";
     }},
    {"Ctrl+1", "tiles.keep1", keeps<0>},
    {"Ctrl+2", "tiles.keep2", keeps<1>},
    {"Ctrl+3", "tiles.keep3", keeps<2>},
    {"Ctrl+4", "tiles.keep4", keeps<3>},
    {"Ctrl+5", "tiles.keep5", keeps<4>},
    {"Ctrl+6", "tiles.keep6", keeps<5>},
    {"Ctrl+7", "tiles.keep7", keeps<6>},
    {"Ctrl+8", "tiles.keep8", keeps<7>},
    {"Ctrl+9", "tiles.keep9", keeps<8>},
    {"1", "tiles.recall1", recalls<0>},
    {"2", "tiles.recall2", recalls<1>},
    {"3", "tiles.recall3", recalls<2>},
    {"4", "tiles.recall4", recalls<3>},
    {"5", "tiles.recall5", recalls<4>},
    {"6", "tiles.recall6", recalls<5>},
    {"7", "tiles.recall7", recalls<6>},
    {"8", "tiles.recall8", recalls<7>},
    {"9", "tiles.recall9", recalls<8>},
};

}  // namespace

std::span<const KeyTrial> toolAndTileTrials() { return kTrials; }

}  // namespace plumb::editor::ui
