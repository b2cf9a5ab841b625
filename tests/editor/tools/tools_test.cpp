#include <algorithm>

#include "editor/model/actions.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tools/move_tool.hpp"
#include "editor/model/tools/rotate_tool.hpp"
#include "editor/model/tools/scale_tool.hpp"
#include "editor/model/tools/select_tool.hpp"
#include "editor/model/tools/tile_tools.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

using Tools = EditorFixture;

TEST_F(Tools, aDragOfManyMouseMovesIsUndoneInOneStep) {
    workspace.document.selection.set({named("crate"), named("sign")});
    const ToolContext context = workspace.tools();

    MoveTool tool;
    tool.press(context, {.position = {210.0f, 70.0f}});
    for (float x = 1.0f; x <= 30.0f; x += 1.0f) {
        tool.drag(context, {.position = {210.0f + x, 70.0f}});
    }
    tool.release(context, {});
    EXPECT_EQ(positionOf(named("crate")), (Vec2{230.0f, 64.0f}));
    EXPECT_EQ(positionOf(named("sign")), (Vec2{130.0f, 20.0f}));
    EXPECT_EQ(workspace.undo.size(), 1u);

    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(positionOf(named("crate")), (Vec2{200.0f, 64.0f}));
    EXPECT_EQ(positionOf(named("sign")), (Vec2{100.0f, 20.0f}));
    ASSERT_TRUE(workspace.undo.redo());
    EXPECT_EQ(positionOf(named("crate")), (Vec2{230.0f, 64.0f}));
}

TEST_F(Tools, aDragBackToTheStartLeavesNoUndoStep) {
    workspace.document.selection.set({named("crate")});
    MoveTool tool;
    tool.press(workspace.tools(), {.position = {210.0f, 70.0f}});
    tool.drag(workspace.tools(), {.position = {250.0f, 70.0f}});
    tool.drag(workspace.tools(), {.position = {210.0f, 70.0f}});
    tool.release(workspace.tools(), {});
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Tools, escapeTakesADragBack) {
    workspace.document.selection.set({named("crate")});
    MoveTool tool;
    tool.press(workspace.tools(), {.position = {210.0f, 70.0f}});
    tool.drag(workspace.tools(), {.position = {250.0f, 70.0f}});
    EXPECT_TRUE(tool.cancel(workspace.tools()));
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Tools, draggedEntitiesSnapToTheGrid) {
    workspace.document.selection.set({named("crate")});
    MoveTool tool;
    tool.press(workspace.tools(), {.position = {210.0f, 70.0f}});
    tool.drag(workspace.tools(), {.position = {221.0f, 79.0f}, .snap = true});
    EXPECT_EQ(positionOf(named("crate")), (Vec2{208.0f, 80.0f}));
}

TEST_F(Tools, aSpriteOfWholeCellsSnapsByItsCornerEvenIfItsPivotIsCentered) {
    auto& sprite = workspace.document.world.add<Sprite>(workspace.document.find(named("crate")));
    sprite.width = 48;
    sprite.height = 16;
    sprite.pivot = {0.5f, 0.5f};
    workspace.document.selection.set({named("crate")});
    MoveTool tool;
    tool.press(workspace.tools(), {.position = {210.0f, 70.0f}});
    tool.drag(workspace.tools(), {.position = {221.0f, 79.0f}, .snap = true});
    const Vec2 corner = positionOf(named("crate")) - Vec2{24.0f, 8.0f};
    EXPECT_EQ(corner, snapped(corner, {16.0f, 16.0f}));
}

TEST_F(Tools, aSelectedChildOfASelectedParentIsMovedOnce) {
    workspace.document.selection.set({named("player"), named("lamp")});
    MoveTool tool;
    tool.press(workspace.tools(), {.position = {45.0f, 110.0f}});
    tool.drag(workspace.tools(), {.position = {65.0f, 110.0f}});
    EXPECT_EQ(positionOf(named("player")), (Vec2{60.0f, 100.0f}));
    EXPECT_EQ(positionOf(named("lamp")), (Vec2{10.0f, -10.0f}));
}

TEST_F(Tools, aBoxSelectsWhatItTouchesButNotTheGround) {
    SelectTool tool;
    tool.press(workspace.tools(), {.position = {190.0f, 130.0f}});
    tool.drag(workspace.tools(), {.position = {300.0f, 50.0f}});
    tool.release(workspace.tools(), {.position = {300.0f, 50.0f}});
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("crate")});
}

TEST_F(Tools, aClickGoesThroughTheHolesOfATileLayer) {
    const Document& document = workspace.document;
    const auto picked = [&](int x, int y) {
        const AABB cell = boxOfCell(document, named("ground"), {x, y});
        return pickFirst(document, cell.center(), 1.0f);
    };
    EXPECT_EQ(picked(1, 1), named("ground"));
    EXPECT_FALSE(picked(3, 0));
}

TEST_F(Tools, aDragOnATileLayerSelectsByABoxUnlessTheLayerIsSelected) {
    const Vec2 from = boxOfCell(workspace.document, named("ground"), {1, 1}).center();
    const Vec2 before = positionOf(named("ground"));
    SelectTool tool;
    const auto dragIt = [&] {
        tool.press(workspace.tools(), {.position = from});
        tool.drag(workspace.tools(), {.position = from + Vec2{32.0f, 0.0f}});
        tool.release(workspace.tools(), {.position = from + Vec2{32.0f, 0.0f}});
    };
    dragIt();
    EXPECT_EQ(positionOf(named("ground")), before);
    EXPECT_EQ(workspace.undo.size(), 0u);
    workspace.document.selection.set({named("ground")});
    dragIt();
    EXPECT_NE(positionOf(named("ground")), before);
}

TEST_F(Tools, aStrokeOfTheBrushIsOneStepAndLeavesNoHoles) {
    workspace.document.selection.set({named("ground")});
    TileTool tool{TileTool::Mode::Brush};
    workspace.tiles.stamp.cells = {3};
    tool.press(workspace.tools(), {.position = {2.0f, 2.0f}});
    tool.drag(workspace.tools(), {.position = {62.0f, 2.0f}});
    tool.release(workspace.tools(), {});

    const Document& document = workspace.document;
    const auto& layer = document.world.get<TileLayer>(document.find(named("ground")));
    for (int x = 0; x < 4; ++x) {
        EXPECT_EQ(document.world.tiles().find(layer.cells)->at(x, 0), 3u);
    }
    EXPECT_EQ(workspace.undo.size(), 1u);
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Tools, arrowKeyNudgesAreMergedIntoOneStep) {
    workspace.document.selection.set({named("crate")});
    const Event right{.kind = EventKind::KeyDown, .key = Key::Right};
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(runShortcut(workspace, right));
    }
    EXPECT_EQ(positionOf(named("crate")), (Vec2{205.0f, 64.0f}));
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(Tools, noTwoActionsThatCountAtOnceShareAShortcut) {
    // An action for entities or for tiles takes precedence over one for `Always` with the same shortcut.
    for (const During now : {During::Entities, During::Tiles, During::Halted, During::Always}) {
        std::vector<std::string> seen;
        for (const Action& action : actionTable()) {
            if (action.during != now) continue;
            for (const Shortcut& shortcut : {action.shortcut, action.alternative}) {
                if (shortcut.key == Key::None) continue;
                EXPECT_EQ(std::count(seen.begin(), seen.end(), shortcut.text()), 0) << shortcut.text();
                seen.push_back(shortcut.text());
            }
        }
    }
}

TEST_F(Tools, zoomingKeepsWhatIsUnderTheCursor) {
    ViewCamera camera;
    camera.resize({800.0f, 600.0f});
    const Vec2 cursor{120.0f, 430.0f};
    for (int i = 0; i < 30; ++i) {
        const Vec2 before = camera.toWorldPoint(cursor);
        camera.zoomAt(cursor, i < 15 ? 1.0f : -1.0f);
        EXPECT_LT(distance(before, camera.toWorldPoint(cursor)), 0.01f);
    }
}

}  // namespace
}  // namespace plumb::editor
