#include "editor/model/actions.hpp"
#include "editor/model/tools/move_tool.hpp"
#include "editor/model/tools/rotate_tool.hpp"
#include "editor/model/tools/scale_tool.hpp"
#include "math/angle.hpp"
#include "scene/world_transform.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

class Handles : public EditorFixture {
protected:
    Handles() { workspace.document.selection.set({named("crate")}); }

    [[nodiscard]] const Transform& crate() const {
        return workspace.document.world.get<Transform>(workspace.document.find(named("crate")));
    }
    void drag(Tool& tool, Vec2 from, Vec2 to, Pointer how = {}) {
        const Vec2 way = to - from;
        how.position = from;
        tool.press(workspace.tools(), how);
        for (int i = 1; i <= 8; ++i) {
            how.position = from + way * (static_cast<float>(i) / 8.0f);
            tool.drag(workspace.tools(), how);
        }
        tool.release(workspace.tools(), how);
    }
};

const Vec2 kCrate{200.0f, 64.0f};

TEST_F(Handles, anArrowMovesAlongItsAxisOnly) {
    const AxisHandles handles{kCrate};
    MoveTool tool;
    drag(tool, handles.middleOf(Handle::X), handles.middleOf(Handle::X) + Vec2{30.0f, 55.0f});
    EXPECT_EQ(crate().position, (Vec2{230.0f, 64.0f}));

    const AxisHandles there{crate().position};
    drag(tool, there.middleOf(Handle::Y), there.middleOf(Handle::Y) + Vec2{30.0f, 55.0f});
    EXPECT_EQ(crate().position, (Vec2{230.0f, 119.0f}));
    EXPECT_EQ(workspace.undo.size(), 2u);
    workspace.undo.jumpTo(0);
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Handles, theSquareMovesFreelyAndSnapsToTheGrid) {
    const AxisHandles handles{kCrate};
    MoveTool tool;
    drag(tool, handles.middleOf(Handle::Both), handles.middleOf(Handle::Both) + Vec2{21.0f, 13.0f},
         {.snap = true});
    EXPECT_EQ(crate().position, (Vec2{224.0f, 80.0f}));
}

TEST_F(Handles, keepTheirSizeOnScreenAtAnyZoom) {
    for (const float pixel : {0.1f, 1.0f, 8.0f}) {
        const AxisHandles handles{kCrate, 0.0f, pixel};
        EXPECT_EQ(handles.at(kCrate + Vec2{40.0f, 0.0f} * pixel), Handle::X);
        EXPECT_EQ(handles.at(kCrate + Vec2{0.0f, 40.0f} * pixel), Handle::Y);
        EXPECT_EQ(handles.at(kCrate + Vec2{15.0f, 15.0f} * pixel), Handle::Both);
        EXPECT_EQ(handles.at(kCrate + Vec2{40.0f, 20.0f} * pixel), Handle::None);
        for (const Handle handle : {Handle::X, Handle::Y, Handle::Both}) {
            EXPECT_EQ(handles.at(handles.middleOf(handle)), handle);
        }
    }
}

TEST_F(Handles, aDragBesideTheHandlesSelectsByABox) {
    workspace.document.selection.set({named("sign")});
    MoveTool tool;
    drag(tool, {190.0f, 130.0f}, {300.0f, 50.0f});
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("crate")});
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Handles, theRingRotatesByTheAngleOfTheDrag) {
    RotateTool tool;
    const Vec2 arm{RotateTool::kRing, 0.0f};
    drag(tool, kCrate + arm, kCrate + rotated(arm, 1.1f));
    EXPECT_NEAR(crate().rotation, 1.1f, 1e-4f);
    EXPECT_EQ(crate().position, kCrate) << "it turns about its own origin";

    drag(tool, kCrate + arm, kCrate + rotated(arm, 0.3f), {.snap = true});
    EXPECT_NEAR(crate().rotation, radiansFromDegrees(75.0f), 1e-4f) << "63 + 17 degrees, in steps of 15";
    EXPECT_EQ(workspace.undo.size(), 2u);
    workspace.undo.jumpTo(0);
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Handles, severalEntitiesRotateAboutTheActiveOne) {
    workspace.document.selection.set({named("sign"), named("crate")});
    RotateTool tool;
    const Vec2 arm{RotateTool::kRing, 0.0f};
    const Vec2 before = positionOf(named("sign")) - kCrate;
    drag(tool, kCrate + arm, kCrate + rotated(arm, 0.8f));
    EXPECT_LT(distance(positionOf(named("sign")), kCrate + rotated(before, 0.8f)), 0.01f);
}

TEST_F(Handles, aDragByTheHandleLengthDoublesTheScale) {
    ScaleTool tool;
    const AxisHandles handles{kCrate};
    const Vec2 grip = handles.middleOf(Handle::X);
    drag(tool, grip, grip + Vec2{AxisHandles::kArm, 20.0f});
    EXPECT_EQ(crate().scale, (Vec2{2.0f, 1.0f}));

    const Vec2 square = handles.middleOf(Handle::Both);
    drag(tool, square, square - Vec2{AxisHandles::kArm, AxisHandles::kArm} * 0.5f, {.snap = true});
    EXPECT_EQ(crate().scale, (Vec2{1.0f, 0.5f}));
    EXPECT_EQ(crate().position, kCrate);
}

TEST_F(Handles, theScaleNeverBecomesZero) {
    ScaleTool tool;
    const Vec2 grip = AxisHandles{kCrate}.middleOf(Handle::X);
    drag(tool, grip, grip - Vec2{AxisHandles::kArm, 0.0f});
    EXPECT_EQ(crate().scale, (Vec2{0.01f, 1.0f}));
}

TEST_F(Handles, escapeTakesBackWhatAHandleDid) {
    MoveTool move;
    RotateTool turn;
    ScaleTool scale;
    const Vec2 onRing = kCrate + Vec2{0.0f, RotateTool::kRing};
    const std::pair<Tool*, Vec2> grips[] = {{&move, AxisHandles{kCrate}.middleOf(Handle::X)},
                                            {&turn, onRing},
                                            {&scale, AxisHandles{kCrate}.middleOf(Handle::Both)}};
    for (const auto& [tool, grip] : grips) {
        tool->press(workspace.tools(), {.position = grip});
        tool->drag(workspace.tools(), {.position = grip + Vec2{40.0f, 30.0f}});
        EXPECT_NE(workspace.text(), kSceneText);
        EXPECT_TRUE(tool->cancel(workspace.tools()));
        EXPECT_EQ(workspace.text(), kSceneText);
    }
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Handles, everyToolDrawsWithAndWithoutASelection) {
    for (std::size_t i = 0; i < toolTable().size(); ++i) {
        SCOPED_TRACE(toolTable()[i].name);
        workspace.useTool(i);
        workspace.document.selection.set({named("crate")});
        Overlay overlay;
        workspace.tool().draw(workspace.tools(), {.position = kCrate}, overlay);
        EXPECT_EQ(overlay.shapes().empty(), toolTable()[i].name == "Select");
        workspace.document.selection.clear();
        workspace.tool().draw(workspace.tools(), {.position = kCrate}, overlay);
    }
}

TEST_F(Handles, shiftAndAnArrowKeyMoveByOneCell) {
    const Event down{.kind = EventKind::KeyDown, .key = Key::Down, .modifiers = {.shift = true}};
    EXPECT_TRUE(runShortcut(workspace, down));
    EXPECT_TRUE(runShortcut(workspace, down));
    EXPECT_EQ(crate().position, (Vec2{200.0f, 96.0f}));
    workspace.undo.endGesture();
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(Handles, aKeySelectsAnotherToolForTilesThanForEntities) {
    const Event key{.kind = EventKind::KeyDown, .key = Key::E};
    EXPECT_TRUE(runShortcut(workspace, key));
    EXPECT_EQ(toolTable()[workspace.toolIndex()].action, "tool.rotate");
    workspace.useTool("tool.brush");
    EXPECT_TRUE(runShortcut(workspace, key));
    EXPECT_EQ(toolTable()[workspace.toolIndex()].action, "tool.erase");
}

TEST_F(Handles, everyActionIsFoundInAMenuOrByAKey) {
    for (const Action& action : actionTable()) {
        EXPECT_TRUE(!action.menu.empty() || action.shortcut.key != Key::None) << action.id;
        if (action.id.empty()) continue;
        EXPECT_EQ(findAction(action.id), &action);
    }
}

}  // namespace
}  // namespace plumb::editor
