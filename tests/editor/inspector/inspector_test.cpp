#include <array>
#include <cmath>

#include "core/text.hpp"
#include "editor/ui/fields/field_row.hpp"
#include "scene/components/colliders/polygon_collider.hpp"
#include "scene/components/joints/revolute_joint.hpp"
#include "scene/components/scene_physics.hpp"
#include "tests/editor/support/inspector_fixture.hpp"

namespace plumb::editor::ui {
namespace {

// ---- several selected entities

TEST_F(Inspector, aNumberTypedForSeveralChangesOnlyThatNumberInOneStep) {
    select({"player", "crate", "sign"});
    EXPECT_EQ(valueOf("Inspector/count"), "3");
    EXPECT_EQ(valueOf(kX), kMixed);
    hands.enterNumber(kX, "16*3+4");
    EXPECT_EQ(positionOf(named("player")), (Vec2{52, 100}));
    EXPECT_EQ(positionOf(named("crate")), (Vec2{52, 64}));
    EXPECT_EQ(positionOf(named("sign")), (Vec2{52, 20}));
    EXPECT_EQ(valueOf(kX), "52");
    EXPECT_EQ(valueOf(kY), kMixed);
    EXPECT_EQ(workspace.undo.size(), 1u);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Inspector, signsChangeEachFromWhatItIs) {
    select({"player", "crate", "sign"});  // x is 40, 200 and 100
    const auto xs = [&] {
        return std::array{positionOf(named("player")).x, positionOf(named("crate")).x,
                          positionOf(named("sign")).x};
    };
    const struct {
        const char* text;
        std::array<float, 3> after;
    } steps[] = {{"+=10", {50, 210, 110}},  {"-=5*2", {40, 200, 100}}, {"*=2", {80, 400, 200}},
                 {"/2", {40, 200, 100}},    {"*3", {120, 600, 300}},   {"/=3", {40, 200, 100}},
                 {"x+16*i", {40, 216, 132}}};
    std::size_t count = 0;
    for (const auto& [text, after] : steps) {
        hands.enterNumber(kX, text);
        EXPECT_EQ(xs(), after) << text;
        EXPECT_EQ(workspace.undo.size(), ++count) << text;
    }
    workspace.undo.jumpTo(0);
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Inspector, anExpressionThatFailsForOneEntityChangesNone) {
    select({"player", "crate"});
    hands.enterNumber(kX, "1/(x-40)");  // division by zero for the player, whose x is 40
    EXPECT_EQ(workspace.undo.total(), 0u);
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Inspector, draggingMovesAllByAsMuchInOneStepAndEscapeGivesThemBack) {
    select({"player", "crate"});
    dragBy(kX, 40.0f);
    const float by = positionOf(named("player")).x - 40.0f;
    EXPECT_GT(by, 20.0f);
    EXPECT_EQ(positionOf(named("crate")), (Vec2{200 + by, 64})) << "still as far apart";
    EXPECT_EQ(workspace.undo.size(), 1u);
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(workspace.text(), kSceneText);

    hands.rest(30);
    hands.moveTo(hands.middleOf(kX));
    hands.rest(), hands.press();
    hands.moveTo(hands.middleOf(kX) + Vec2{30, 0});
    hands.rest();
    ASSERT_NE(positionOf(named("player")).x, 40.0f);
    hands.key(Key::Escape);
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_EQ(workspace.document.selection.size(), 2u) << "Esc belonged to the drag";
    hands.moveTo(hands.middleOf(kX) + Vec2{60, 0});
    hands.release();
    hands.rest();
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(Inspector, onlyWhatAllHaveIsShownAndTheRestIsCountedAndCanBeSelected) {
    select({"player", "crate", "sign"});
    EXPECT_NE(widget("Inspector/Transform"), nullptr);
    EXPECT_EQ(widget("Inspector/BoxCollider"), nullptr);
    EXPECT_EQ(valueOf("Inspector/partly"), "3");
    EXPECT_EQ(valueOf("Inspector/partly/BoxCollider"), "2");
    EXPECT_EQ(valueOf("Inspector/partly/Label"), "1");
    hands.click("Inspector/partly/BoxCollider");
    hands.rest();
    EXPECT_EQ(workspace.document.selection.all(), (std::vector{named("player"), named("crate")}));
    EXPECT_EQ(valueOf("Inspector/BoxCollider/width"), kMixed);
    EXPECT_EQ(workspace.undo.total(), 0u) << "selecting is no edit";
}

TEST_F(Inspector, boxesLayersAndListsOfNamesShowADashAndMakeAllAgree) {
    workspace.project.layers = {"ground", "player"};
    BoxCollider box{8, 8};
    give("crate", (box.layers = 3, box));
    give("player", (box.layers = 1, box.isTrigger = true, box));
    select({"player", "crate"});
    EXPECT_EQ(valueOf("Inspector/BoxCollider/isTrigger"), kMixed);
    hands.click("Inspector/BoxCollider/isTrigger");
    EXPECT_TRUE(of<BoxCollider>("player").isTrigger && of<BoxCollider>("crate").isTrigger);

    EXPECT_EQ(valueOf("Inspector/BoxCollider/layers"), kMixed);
    hands.click("Inspector/BoxCollider/layers");
    EXPECT_EQ(valueOf("Inspector/BoxCollider/layers/1"), "on");
    EXPECT_EQ(valueOf("Inspector/BoxCollider/layers/2"), kMixed);
    hands.click("Inspector/BoxCollider/layers/3");
    EXPECT_EQ(of<BoxCollider>("player").layers, 5u) << "only that bit";
    EXPECT_EQ(of<BoxCollider>("crate").layers, 7u);
    hands.click("Inspector/BoxCollider/layers/2");
    EXPECT_EQ(of<BoxCollider>("player").layers, 7u);
    hands.key(Key::Escape);
    EXPECT_EQ(valueOf("Inspector/BoxCollider/layers"), "3 layers");
    EXPECT_EQ(workspace.undo.size(), 3u);
}

TEST_F(Inspector, inTheRunningGameItWritesIntoTheGameForAll) {
    select({"player", "crate"});
    hands.key(Key::F5);
    hands.key(Key::F6);
    ASSERT_TRUE(workspace.play.running());
    hands.enterNumber("Inspector/BoxCollider/width", "+=4");
    hands.enterNumber("Inspector/Transform/scale.x", "2");
    const World& world = workspace.play.world();
    EXPECT_EQ(world.get<BoxCollider>(workspace.play.find(named("player"))).width, 20.0f);
    EXPECT_EQ(world.get<BoxCollider>(workspace.play.find(named("crate"))).width, 35.0f);
    EXPECT_EQ(workspace.text(), kSceneText);
    hands.key(Key::F5);
    hands.rest(2);
    EXPECT_EQ(workspace.offeredChanges.size(), 4u);
    hands.click("Keep/keep");
    hands.rest(2);
    EXPECT_EQ(of<BoxCollider>("crate").width, 35.0f);
    EXPECT_EQ(workspace.undo.size(), 1u);
}

// ---- numbers

TEST_F(Inspector, shiftDragsTenTimesAsFastAndAltAHundredthAsFast) {
    select({"crate"});
    dragBy(kX, 50.0f);
    const float plain = positionOf(named("crate")).x - 200.0f;
    ASSERT_EQ(plain, std::round(plain)) << "whole pixels";
    workspace.undo.undo();
    hands.held = {.shift = true};
    dragBy(kX, 50.0f);
    EXPECT_FLOAT_EQ(positionOf(named("crate")).x - 200.0f, plain * 10.0f);
    workspace.undo.undo();
    hands.held = {.alt = true};
    dragBy(kX, 50.0f);
    EXPECT_NEAR(positionOf(named("crate")).x - 200.0f, plain * 0.01f, 1e-4f);
    hands.held = {};
}

TEST_F(Inspector, whatIsWrongIsSaidWithItsColumnAndTheValueStays) {
    select({"crate"});
    hands.enterNumber(kX, "16*(3");
    EXPECT_EQ(workspace.notice, "\"16*(3\": column 6: expected ) for the ( in column 4, found the end");
    EXPECT_EQ(positionOf(named("crate")).x, 200.0f);
    hands.rest(3);
    EXPECT_EQ(valueOf(kX), "16*(3") << "it can be mended";
    EXPECT_EQ(valueOf("Inspector/Transform/position.x/says"),
              "column 6: expected ) for the ( in column 4, found the end");
    hands.type("7");
    hands.key(Key::Enter);
    EXPECT_EQ(positionOf(named("crate")).x, 7.0f);
}

TEST_F(Inspector, messagesBelowAFieldStayInsideTheWindow) {
    select({"crate"});
    hands.enterNumber("Inspector/Transform/position.y", "16*(3 and then some more");
    hands.rest(3);
    const WidgetMap::Widget* says = window.widgets().find("Inspector/Transform/position.y/says");
    ASSERT_NE(says, nullptr);
    EXPECT_GT(says->box.size().x, 100.0f);
    EXPECT_LE(says->box.max.x, ImGui::GetIO().DisplaySize.x);
}

TEST_F(Inspector, escapeAndAnUnchangedNumberAreNoStepAndKeepWhatCanBeRedone) {
    select({"crate"});
    hands.enterNumber(kX, "7");
    hands.key(Key::Z, {.control = true});
    ASSERT_EQ(workspace.undo.total(), 1u);
    hands.enterNumber(kX, "200");
    hands.enterNumber(kX, "*1");
    doubleClick(kX);
    hands.type("999");
    EXPECT_EQ(valueOf(kX), "999") << "a double click types, too";
    hands.key(Key::Escape);
    hands.rest(2);
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_EQ(workspace.undo.size(), 0u);
    EXPECT_EQ(workspace.undo.total(), 1u) << "redo is still there";
    EXPECT_EQ(workspace.document.selection.size(), 1u);
}

TEST_F(Inspector, typedNumbersStayInTheirRangeAndWholeOnesAreWhole) {
    select({"player"});
    hands.enterNumber("Inspector/RigidBody/bounciness", "3");
    EXPECT_EQ(of<RigidBody>("player").bounciness, 1.0f);
    hands.enterNumber("Inspector/RigidBody/mass", "-5");
    EXPECT_EQ(of<RigidBody>("player").mass, 1e-4f);
    give("lamp", ScenePhysics{});
    select({"lamp"});
    hands.enterNumber("Inspector/ScenePhysics/quality", "5/2");
    EXPECT_EQ(of<ScenePhysics>("lamp").quality, 3);
    hands.enterNumber("Inspector/ScenePhysics/quality", "99");
    EXPECT_EQ(of<ScenePhysics>("lamp").quality, 6);
}

TEST_F(Inspector, anglesAreTypedInDegrees) {
    select({"crate"});
    hands.enterNumber("Inspector/Transform/rotation", "45*2");
    EXPECT_FLOAT_EQ(of<Transform>("crate").rotation, 1.57079637f);
    EXPECT_EQ(valueOf("Inspector/Transform/rotation"), "90");
    hands.enterNumber("Inspector/Transform/rotation", "deg(pi/4)");
    EXPECT_EQ(valueOf("Inspector/Transform/rotation"), "45");
}

TEST_F(Inspector, tabGoesToTheNextNumberAndShiftTabBack) {
    select({"crate"});
    doubleClick(kX);
    hands.type("11");
    hands.key(Key::Tab);
    hands.rest(3);
    EXPECT_EQ(positionOf(named("crate")), (Vec2{11, 64}));
    hands.type("22");
    hands.key(Key::Tab, {.shift = true});
    hands.rest(3);
    EXPECT_EQ(positionOf(named("crate")), (Vec2{11, 22}));
    hands.type("33");
    hands.key(Key::Enter);
    EXPECT_EQ(positionOf(named("crate")), (Vec2{33, 22}));
    EXPECT_EQ(workspace.undo.size(), 3u);
}

TEST_F(Inspector, aClickOnAnotherEntityWhileTypingKeepsWhatWasTyped) {
    select({"crate"});
    doubleClick(kX);
    hands.type("77");
    hands.click("Scene/sign");
    hands.rest(2);
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("sign")});
    EXPECT_EQ(positionOf(named("crate")), (Vec2{77, 64}));
    EXPECT_EQ(positionOf(named("sign")), (Vec2{100, 20}));
    EXPECT_EQ(workspace.undo.size(), 1u);
}

// ---- single values

TEST_F(Inspector, whatIsNotTheDefaultIsMarkedAndResetByItsArrowOrItsMenu) {
    select({"player"});
    EXPECT_EQ(valueOf("Inspector/RigidBody/mass/label"), "");
    EXPECT_EQ(widget("Inspector/RigidBody/mass/arrow"), nullptr);
    hands.enterNumber("Inspector/RigidBody/mass", "4");
    EXPECT_EQ(valueOf("Inspector/RigidBody/mass/label"), "changed");
    hands.click("Inspector/RigidBody/mass/arrow");
    EXPECT_EQ(of<RigidBody>("player").mass, 1.0f);
    EXPECT_EQ(workspace.undo.size(), 2u);
    hands.enterNumber("Inspector/RigidBody/mass", "4");
    menu("Inspector/RigidBody/mass", "Inspector/RigidBody/mass/reset");
    EXPECT_EQ(of<RigidBody>("player").mass, 1.0f);
}

TEST_F(Inspector, aValueIsCopiedAsTextAndPastedOntoSeveral) {
    select({"crate"});
    menu("Inspector/Transform/position/label", "Inspector/Transform/position/copy");
    EXPECT_EQ(workspace.clipboard, "[200, 64]");
    select({"player", "sign"});
    menu(kX, "Inspector/Transform/position/paste");
    EXPECT_EQ(positionOf(named("player")), (Vec2{200, 64}));
    EXPECT_EQ(positionOf(named("sign")), (Vec2{200, 64}));
    EXPECT_EQ(workspace.undo.size(), 1u);
    workspace.clipboard = "somewhere";
    menu(kX, "Inspector/Transform/position/paste");
    EXPECT_EQ(workspace.undo.size(), 1u);
    EXPECT_NE(workspace.notice.find("clipboard"), std::string::npos) << workspace.notice;
}

TEST_F(Inspector, fieldsWithoutEffectAreNotShown) {
    give("lamp", RevoluteJoint{});
    select({"lamp"});
    EXPECT_EQ(widget("Inspector/RevoluteJoint/lower"), nullptr);
    hands.click("Inspector/RevoluteJoint/limited");
    hands.rest();
    EXPECT_NE(widget("Inspector/RevoluteJoint/lower"), nullptr);
}

TEST_F(Inspector, aColorIsTypedInCommonNotations) {
    select({"sign"});
    for (const auto& [typed, expected] :
         {std::pair{"#f80", Color{255, 136, 0, 255}}, std::pair{"00ff0080", Color{0, 255, 0, 128}}}) {
        hands.click("Inspector/Label/color.hex");
        hands.rest(3);
        hands.type(typed);
        hands.key(Key::Enter);
        EXPECT_EQ(of<Label>("sign").color, expected) << typed;
    }
    EXPECT_EQ(workspace.undo.size(), 2u);
    hands.click("Inspector/Label/color.hex");
    hands.rest(3);
    hands.type("red");
    hands.key(Key::Enter);
    EXPECT_EQ(of<Label>("sign").color, (Color{0, 255, 0, 128}));
    EXPECT_NE(workspace.notice.find("#rrggbb"), std::string::npos);
}

TEST_F(Inspector, aTextIsTypedForSeveral) {
    give("crate", Label{});
    select({"sign", "crate"});
    EXPECT_EQ(valueOf("Inspector/Label/text"), kMixed);
    hands.click("Inspector/Label/text");
    hands.rest(3);
    hands.type("Exit");
    hands.key(Key::Enter);
    const auto text = [&](const char* name) {
        return std::string{workspace.document.world.texts().find(of<Label>(name).text)};
    };
    EXPECT_EQ(text("sign"), "Exit");
    EXPECT_EQ(text("crate"), "Exit");
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(Inspector, aListGrowsAndShrinksAndItsPointsAreTyped) {
    PolygonCollider shape;
    shape.points.clear();
    for (const Vec2 point : {Vec2{0, 0}, Vec2{10, 0}, Vec2{0, 10}}) shape.points.push(point);
    give("lamp", shape);
    select({"lamp"});
    hands.enterNumber("Inspector/PolygonCollider/points.1.x", "24");
    EXPECT_EQ(of<PolygonCollider>("lamp").points[1], (Vec2{24, 0}));
    hands.click("Inspector/PolygonCollider/points/more");
    ASSERT_EQ(of<PolygonCollider>("lamp").points.size(), 4u);
    EXPECT_EQ(of<PolygonCollider>("lamp").points[3], (Vec2{0, 10}));
    hands.rest();
    hands.click("Inspector/PolygonCollider/points/less");
    ASSERT_EQ(of<PolygonCollider>("lamp").points.size(), 3u);
    EXPECT_EQ(of<PolygonCollider>("lamp").points.items[3], Vec2{}) << "unused places are empty";
    EXPECT_EQ(workspace.undo.size(), 3u);
}

}  // namespace
}  // namespace plumb::editor::ui
