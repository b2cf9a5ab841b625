// Mouse gestures in the viewport, with and without modifier keys.

#include <cmath>

#include "scene/components/colliders/polygon_collider.hpp"
#include "tests/editor/keys/desk.hpp"

namespace plumb::editor::ui {
namespace {

using Gestures = Desk;

TEST_F(Gestures, theMiddleButtonPans) {
    const View before = workspace.view.view();
    const Vec2 middle = hands.middleOf("Viewport");
    dragWith(MouseButton::Middle, middle, middle + Vec2{40.0f, -20.0f});
    const Vec2 moved = (before.center - workspace.view.view().center) * before.zoom;
    EXPECT_NEAR(moved.x, 40.0f, 0.01f);
    EXPECT_NEAR(moved.y, -20.0f, 0.01f);
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Gestures, spaceAndADragPanAndSelectNothing) {
    const View before = workspace.view.view();
    const Vec2 crate = onScreen({216.0f, 80.0f});
    hold(Key::Space);
    hands.drag(crate, crate + Vec2{30.0f, 10.0f});
    letGo(Key::Space);
    EXPECT_NEAR((before.center.x - workspace.view.view().center.x) * before.zoom, 30.0f, 0.01f);
    EXPECT_TRUE(workspace.document.selection.empty());
    EXPECT_EQ(workspace.text(), kSceneText);
    hands.clickAt(onScreen({216.0f, 80.0f}));
    EXPECT_TRUE(selects({"crate"})) << "without Space it selects again";
}

TEST_F(Gestures, theWheelZoomsAtTheMouse) {
    const Vec2 corner = window.widgets().find("Viewport")->box.min;
    const Vec2 at{std::floor(corner.x) + 390.0f, std::floor(corner.y) + 140.0f};
    const Vec2 under = workspace.view.toWorldPoint(at - corner);
    const float zoom = workspace.view.zoom();
    hands.moveTo(at), hands.rest();
    wheel(3.0f);
    EXPECT_GT(workspace.view.zoom(), zoom * 1.3f);
    EXPECT_LT(distance(workspace.view.toWorldPoint(at - corner), under), 0.05f);
    wheel(-6.0f);
    EXPECT_LT(workspace.view.zoom(), zoom);
    EXPECT_LT(distance(workspace.view.toWorldPoint(at - corner), under), 0.05f);
}

TEST_F(Gestures, lookingAndSelectingAreNoEdits) {
    const Vec2 middle = hands.middleOf("Viewport");
    dragWith(MouseButton::Middle, middle, middle + Vec2{40.0f, 0.0f});
    hands.moveTo(middle), wheel(2.0f);
    select({"crate", "sign"});
    for (const char* keys :
         {"Ctrl+H", "Ctrl+L", "Ctrl+Alt+H", "F", "Shift+F", "Ctrl+0", "Tab", "Tab", "Alt+1", "Alt+2",
          "Shift+S", "F3", "Shift+F3", "W", "B", "H", "K", "Q", "Escape"})
        press(keys);
    hands.click("Overlay/grid");
    hands.click("Scene/lamp/eye");
    EXPECT_EQ(workspace.undo.total(), 0u);
    EXPECT_FALSE(workspace.unsaved());
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Gestures, shiftAddsAndControlToggles) {
    hands.clickAt(onScreen({216.0f, 80.0f}));
    hands.held = {.shift = true};
    hands.clickAt(onScreen({45.0f, 115.0f}));
    EXPECT_TRUE(selects({"crate", "player"}));
    hands.clickAt(onScreen({216.0f, 80.0f}));
    EXPECT_EQ(workspace.document.selection.size(), 2u) << "Shift takes none out";
    hands.held = {.control = true};
    hands.clickAt(onScreen({216.0f, 80.0f}));
    EXPECT_TRUE(selects({"player"}));
    hands.clickAt(onScreen({216.0f, 80.0f}));
    EXPECT_TRUE(selects({"player", "crate"}));
    hands.held = {};
    hands.clickAt(onScreen({216.0f, 80.0f}));
    EXPECT_TRUE(selects({"crate"})) << "one of several, clicked: that one alone";
}

TEST_F(Gestures, aDragBesideThingsSelectsABox) {
    hands.drag(onScreen({260.0f, 130.0f}), onScreen({190.0f, 50.0f}));
    EXPECT_TRUE(selects({"crate"}));
    hands.held = {.shift = true};
    hands.drag(onScreen({36.0f, 140.0f}), onScreen({60.0f, 108.0f}));
    EXPECT_TRUE(workspace.document.selection.has(named("player")));
    EXPECT_TRUE(workspace.document.selection.has(named("crate"))) << "Shift adds";
    hands.held = {.control = true};
    hands.drag(onScreen({260.0f, 130.0f}), onScreen({190.0f, 50.0f}));
    EXPECT_FALSE(workspace.document.selection.has(named("crate"))) << "Ctrl takes out what is in";
    hands.held = {.shift = true};
    hands.drag(onScreen({60.0f, 40.0f}), onScreen({70.0f, 120.0f}));
    EXPECT_FALSE(workspace.document.selection.has(named("ground")))
        << "a box that begins on tiles is no click on them";
    hands.clickAt(onScreen({60.0f, 40.0f}));
    EXPECT_TRUE(workspace.document.selection.has(named("ground")));
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Gestures, altTakesTheNextOneBelow) {
    select({"crate"});
    press("Ctrl+D");
    const ObjectId upper = workspace.document.selection.all().front();
    ASSERT_EQ(count("crate"), 2);
    hands.held = {.alt = true};
    hands.clickAt(onScreen({216.0f, 80.0f}));
    ASSERT_EQ(workspace.document.selection.size(), 1u);
    EXPECT_NE(workspace.document.selection.all().front(), upper);
    hands.clickAt(onScreen({216.0f, 80.0f}));
    EXPECT_EQ(workspace.document.selection.all().front(), upper) << "and round again";
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(Gestures, altAndADragMoveACopy) {
    workspace.grid.snap = false;
    select({"crate", "sign"});
    const Vec2 from = onScreen({216.0f, 80.0f});
    hands.held = {.alt = true};
    hands.drag(from, from + Vec2{0.0f, 48.0f} * workspace.view.zoom());
    hands.held = {};
    EXPECT_EQ(count("crate"), 2);
    EXPECT_EQ(count("sign"), 2);
    const ObjectId copy = workspace.document.selection.all().front();
    EXPECT_EQ(positionOf(copy), (Vec2{200.0f, 112.0f}));
    EXPECT_EQ(positionOf(named("crate")), (Vec2{200.0f, 64.0f})) << "the first one stays";
    EXPECT_EQ(workspace.undo.size(), 1u) << "one step";
    const std::string after = workspace.text();
    press("Ctrl+Z");
    EXPECT_EQ(workspace.text(), kSceneText);
    press("Ctrl+Y");
    EXPECT_EQ(workspace.text(), after) << "where it was let go";
}

TEST_F(Gestures, escapeTakesADraggedCopyAway) {
    select({"crate"});
    const Vec2 from = onScreen({216.0f, 80.0f});
    hands.held = {.alt = true};
    hands.moveTo(from), hands.rest(), hands.press();
    dragOn(from, from + Vec2{0.0f, 60.0f});
    EXPECT_EQ(count("crate"), 2);
    hands.held = {};
    hands.key(Key::Escape);
    hands.release(), hands.rest();
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_TRUE(selects({"crate"}));
    EXPECT_EQ(workspace.undo.total(), 0u);
}

TEST_F(Gestures, whatWasDuplicatedIsDraggedAwayFromTheFirstOnes) {
    workspace.grid.snap = false;
    select({"crate", "sign"});
    press("Ctrl+D");
    const std::vector<ObjectId> copies = workspace.document.selection.all();
    const Vec2 from = onScreen({216.0f, 80.0f});
    hands.drag(from, from + Vec2{0.0f, 48.0f} * workspace.view.zoom());
    EXPECT_EQ(workspace.document.selection.all(), copies);
    for (const ObjectId copy : copies) EXPECT_NE(copy, named("crate"));
    EXPECT_EQ(positionOf(named("crate")), (Vec2{200.0f, 64.0f}));
    EXPECT_EQ(positionOf(copies[0]), (Vec2{200.0f, 112.0f}));
    EXPECT_EQ(positionOf(copies[1]), (Vec2{100.0f, 68.0f}));
}

TEST_F(Gestures, clicksAndDragsGoThroughWhatIsLocked) {
    workspace.document.view.setLocked(named("crate"), true);
    hands.drag(onScreen({216.0f, 80.0f}), onScreen({260.0f, 80.0f}));
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_TRUE(workspace.document.selection.empty());
    hands.click("Scene/crate");
    EXPECT_TRUE(selects({"crate"})) << "the tree still selects it";
}

TEST_F(Gestures, controlInvertsSnappingAlsoWhenItIsHeldBeforeThePress) {
    select({"crate"});
    const Vec2 from = onScreen({216.0f, 80.0f});
    const Vec2 by = Vec2{5.0f, 0.0f} * workspace.view.zoom();
    hands.drag(from, from + by);
    EXPECT_EQ(positionOf(named("crate")).x, 208.0f) << "the next line of the grid";
    press("Ctrl+Z");
    hands.held = {.control = true};
    hands.drag(from, from + by);
    EXPECT_EQ(positionOf(named("crate")).x, 205.0f);
    EXPECT_TRUE(selects({"crate"})) << "a drag is no click";
    hands.held = {};
    press("Ctrl+Z");

    workspace.grid.snap = false;
    hands.moveTo(from), hands.rest(), hands.press();
    hold(Key::LeftControl, {.control = true});
    dragOn(from, from + by);
    hands.release(), letGo(Key::LeftControl);
    EXPECT_EQ(positionOf(named("crate")).x, 208.0f);
}

TEST_F(Gestures, shiftKeepsADragToOneAxis) {
    workspace.grid.snap = false;
    select({"crate"});
    const Vec2 from = onScreen({216.0f, 80.0f});
    hands.held = {.shift = true};
    hands.drag(from, from + Vec2{30.0f, 9.0f} * workspace.view.zoom());
    EXPECT_EQ(positionOf(named("crate")), (Vec2{230.0f, 64.0f}));
}

TEST_F(Gestures, tapsOfArrowsAreOneStepUntilOneRestsOrTakesTheMouse) {
    select({"crate"});
    for (const char* keys : {"Right", "Right", "Shift+Right", "Down"}) press(keys);
    EXPECT_EQ(positionOf(named("crate")), (Vec2{218.0f, 65.0f}));
    EXPECT_EQ(workspace.undo.size(), 1u) << "arrows and Shift+arrows melt";
    hands.rest(90);
    press("Right");
    EXPECT_EQ(workspace.undo.size(), 2u) << "after a rest it is another step";
    hands.clickAt(onScreen({240.0f, 90.0f}));
    press("Right");
    EXPECT_EQ(workspace.undo.size(), 3u) << "and after a click";
    press("Left");
    hands.rest(90);
    EXPECT_EQ(workspace.undo.size(), 2u) << "what came back leaves no step";
    press("Right");
    press("Ctrl+S");
    press("Right");
    EXPECT_TRUE(workspace.unsaved()) << "what comes after saving is another step";
    press("Ctrl+Z");
    EXPECT_FALSE(workspace.unsaved());
}

TEST_F(Gestures, arrowKeysThatReturnToTheStartLeaveNoUndoStep) {
    change();
    const std::string label = workspace.undo.label(0);
    select({"sign"});
    press("Shift+Up"), press("Shift+Down");
    EXPECT_EQ(workspace.undo.size(), 2u) << "until the keys rest";
    press("Ctrl+Z");
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_EQ(workspace.notice, "Undid: " + label);
    EXPECT_EQ(workspace.undo.total(), 1u) << "there and back is no step";
}

TEST_F(Gestures, aHeldArrowIsOneStep) {
    select({"crate"});
    hold(Key::Right);
    for (int i = 0; i < 40; ++i) {
        send({.kind = EventKind::KeyDown, .key = Key::Right, .repeated = true});
        hands.rest(2);
    }
    letGo(Key::Right);
    EXPECT_EQ(positionOf(named("crate")).x, 241.0f);
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(Gestures, aDoubleClickGoesIntoAnInstance) {
    putFile("prefabs/post.prefab.json", R"({"format": 1, "entities": [
        {"id": "0000000000000001", "name": "post", "components": {"Transform": {}, "Sprite": {"width": 40, "height": 40}}},
        {"id": "0000000000000002", "name": "light", "parent": "0000000000000001",
         "components": {"Transform": {}, "Sprite": {"width": 10, "height": 10, "layer": 5}}}]})");
    putFile("scenes/posts.scene.json", R"({"format": 1, "entities": [{"id": "00000000000000a1",
        "prefab": "prefabs/post.prefab.json", "components": {"Transform": {"position": [100, 100]}}}]})");
    ASSERT_TRUE(workspace.open("scenes/posts.scene.json").ok());
    hands.rest(2);
    hands.clickAt(onScreen({100.0f, 100.0f}));
    EXPECT_TRUE(selects({"post"}));
    doubleClickAt(onScreen({100.0f, 100.0f}));
    EXPECT_TRUE(selects({"light"})) << "the part under the mouse";
    EXPECT_EQ(toolInHand(), "tool.select");
}

TEST_F(Gestures, aDoubleClickOnAnOutlineTakesTheToolForItsCorners) {
    World& world = workspace.document.world;
    const EntityId crate = workspace.document.find(named("crate"));
    auto& polygon = world.add<PolygonCollider>(crate);
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{40, 0}, Vec2{40, 40}}) polygon.points.push(corner);
    doubleClickAt(onScreen({216.0f, 80.0f}));
    EXPECT_TRUE(selects({"crate"}));
    EXPECT_EQ(toolInHand(), "tool.shape");
    press("Q");
    doubleClickAt(onScreen({45.0f, 115.0f}));
    EXPECT_EQ(toolInHand(), "tool.select") << "the player has no outline";
}

TEST_F(Gestures, theRightButtonHasAMenuOfWhatLiesUnderIt) {
    hands.clickAt(onScreen({216.0f, 80.0f}), MouseButton::Right);
    hands.rest(2);
    EXPECT_TRUE(selects({"crate"}));
    hands.click("Viewport/menu/Duplicate");
    hands.rest(2);
    EXPECT_EQ(count("crate"), 2);
    EXPECT_FALSE(shown("Viewport/menu/Duplicate"));
}

TEST_F(Gestures, aDoubleClickOnARowShowsItsEntity) {
    workspace.view.show({5000.0f, 5000.0f}, 2.0f);
    doubleClickAt(hands.middleOf("Scene/crate"));
    EXPECT_LT(distance(workspace.view.view().center, {215.5f, 79.5f}), 0.6f);
}

}  // namespace
}  // namespace plumb::editor::ui
