// Gizmo handles and snapping in the real window.

#include "editor/model/tools/handles.hpp"
#include "editor/model/tools/rotate_tool.hpp"
#include "editor/model/tools/shape_handles.hpp"
#include "math/angle.hpp"
#include "tests/editor/keys/desk.hpp"

namespace plumb::editor::ui {
namespace {

class Gizmos : public Desk {
protected:
    Gizmos() { select({"crate"}); }
    [[nodiscard]] const Transform& place() const {
        return std::as_const(workspace.document.world)
            .get<Transform>(workspace.document.find(named("crate")));
    }
    [[nodiscard]] AxisHandles handles() const {
        return {place().position, place().rotation, 1.0f / workspace.view.zoom()};
    }
    /// Drags from a position in the scene by an offset, both in px of the world.
    void pull(Vec2 from, Vec2 by) { hands.drag(onScreen(from), onScreen(from + by)); }
    void expectOneStep() {
        EXPECT_EQ(workspace.undo.size(), 1u);
        press("Ctrl+Z");
        EXPECT_EQ(workspace.text(), kSceneText);
    }
};

TEST_F(Gizmos, anArrowMovesAlongItsAxis) {
    workspace.grid.snap = false;
    press("W");
    pull(handles().middleOf(Handle::X), {30.0f, 12.0f});
    // tolerance: the mouse position is rounded to screen pixels
    EXPECT_NEAR(place().position.x, 230.0f, 1.5f);
    EXPECT_EQ(place().position.y, 64.0f);
    expectOneStep();
    pull(handles().middleOf(Handle::Both), {10.0f, 12.0f});
    EXPECT_NEAR(place().position.x, 210.0f, 1.5f);
    EXPECT_NEAR(place().position.y, 76.0f, 1.5f);
}

TEST_F(Gizmos, handlesScaleWithTheInterface) {
    workspace.grid.snap = false;
    workspace.settings.scale = 2.0f;
    hands.rest(3);
    press("W");
    const float reach = 1.7f * AxisHandles::kArm / workspace.view.zoom();
    pull(place().position + Vec2{reach, 0.0f}, {30.0f, 12.0f});
    EXPECT_NEAR(place().position.x, 230.0f, 1.5f);
    EXPECT_EQ(place().position.y, 64.0f);
}

TEST_F(Gizmos, theRingTurnsInStepsOfFifteenDegreesAndControlTurnsFreely) {
    press("E");
    const float ring = RotateTool::kRing / workspace.view.zoom();
    const auto onRing = [&](float degrees) {
        return place().position + rotated({ring, 0.0f}, radiansFromDegrees(degrees));
    };
    hands.drag(onScreen(onRing(0.0f)), onScreen(onRing(40.0f)), 40);
    EXPECT_NEAR(degreesFromRadians(place().rotation), 45.0f, 0.01f);
    expectOneStep();
    hands.held = {.control = true};
    hands.drag(onScreen(onRing(0.0f)), onScreen(onRing(40.0f)), 40);
    EXPECT_NEAR(degreesFromRadians(place().rotation), 40.0f, 0.5f);
}

TEST_F(Gizmos, aBoxScalesAlongItsAxis) {
    workspace.grid.snap = false;
    press("R");
    const Vec2 box = handles().middleOf(Handle::X);
    pull(box, box - place().position);
    EXPECT_GT(place().scale.x, 1.5f);
    EXPECT_EQ(place().scale.y, 1.0f);
    expectOneStep();
}

TEST_F(Gizmos, aColliderIsDraggedByItsSides) {
    workspace.grid.snap = false;
    press("C");
    const auto collider = [&] {
        return std::as_const(workspace.document.world)
            .get<BoxCollider>(workspace.document.find(named("crate")));
    };
    const BoxCollider before = collider();
    for (const ShapeHandle& spot : spotsOf(workspace.document, named("crate"))) {
        if (spot.kind != ShapeHandleKind::Side || spot.at.x < 225.0f) continue;
        pull(spot.at, {9.0f, 0.0f});
        break;
    }
    EXPECT_NEAR(collider().width, before.width + 9.0f, 1.5f);
    EXPECT_EQ(collider().height, before.height);
    expectOneStep();
}

TEST_F(Gizmos, toWhatThingsSnapIsChosenBesideTheMagnet) {
    const auto afterADrag = [&] {
        hands.drag(onScreen({216.0f, 80.0f}), onScreen({221.0f, 80.0f}));
        const float x = place().position.x;
        press("Ctrl+Z");
        return x;
    };
    const auto choose = [&](const char* what) {
        hands.click("Toolbar/snap settings");
        hands.rest(2);
        hands.click(what);
        hands.rest();
        EXPECT_EQ(valueOf(what), "on");
        hands.key(Key::Escape);
    };
    choose("Snap/Half grid");
    EXPECT_EQ(afterADrag(), 208.0f);
    choose("Snap/Pixels");
    EXPECT_EQ(afterADrag(), 205.0f);
    choose("Snap/Grid");
    workspace.grid.size = {32.0f, 32.0f};
    EXPECT_EQ(afterADrag(), 192.0f);
    EXPECT_FALSE(workspace.unsaved());
}

}  // namespace
}  // namespace plumb::editor::ui
