// Behaviour of ImGui that the editor depends on or works around, tested through user input.

#include <imgui.h>

#include "tests/editor/keys/desk.hpp"

namespace plumb::editor::ui {
namespace {

using InputFacts = Desk;

TEST_F(InputFacts, aPressAndItsReleaseInOneFrameAreBothSeen) {
    hands.moveTo(hands.middleOf("Scene/sign")), hands.rest();
    const Vec2 at = hands.middleOf("Scene/sign");
    const Event click[] = {{.kind = EventKind::MouseDown, .position = at},
                           {.kind = EventKind::MouseUp, .position = at}};
    window.frame({click});
    EXPECT_TRUE(window.pending()) << "the release waits for the next frame";
    hands.rest(3);
    EXPECT_TRUE(selects({"sign"}));

    const Event taps[] = {{.kind = EventKind::KeyDown, .key = Key::Right},
                          {.kind = EventKind::KeyUp, .key = Key::Right},
                          {.kind = EventKind::KeyDown, .key = Key::Right},
                          {.kind = EventKind::KeyUp, .key = Key::Right}};
    window.frame({taps});
    hands.rest(5);
    EXPECT_EQ(positionOf(named("sign")).x, 102.0f) << "none is lost";
    EXPECT_FALSE(window.pending());
}

TEST_F(InputFacts, escapeInANameIsNoStepAndKeepsWhatCanBeRedone) {
    change();
    press("Ctrl+Z");
    const std::size_t redoable = workspace.undo.total();
    select({"sign"});
    for (const char* typed : {"board", "sign"}) {
        press("F2");
        hands.type(typed);
        hands.key(Key::Escape);
        hands.rest(2);
        EXPECT_FALSE(shown("Scene/rename"));
        EXPECT_EQ(workspace.text(), kSceneText);
        EXPECT_EQ(workspace.undo.total(), redoable) << "what was undone can still be redone";
    }
    press("F2");
    hands.key(Key::Enter);
    EXPECT_EQ(workspace.undo.total(), redoable) << "a name that stays as it was is no step";
}

TEST_F(InputFacts, aFieldThatVanishesWhileItIsDraggedEndsItsStep) {
    select({"crate"});
    const Vec2 at = hands.middleOf("Inspector/Transform/position.x");
    hands.moveTo(at), hands.rest(), hands.press();
    dragOn(at, at + Vec2{25.0f, 0.0f});
    EXPECT_TRUE(workspace.undo.inGesture());
    const std::string dragged = workspace.text();
    EXPECT_NE(dragged, kSceneText);
    workspace.document.selection.clear();
    hands.rest(2);
    hands.release(), hands.rest(2);
    EXPECT_FALSE(workspace.undo.inGesture());
    EXPECT_EQ(workspace.undo.size(), 1u);
    EXPECT_EQ(workspace.text(), dragged);
    press("Ctrl+Z");
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(InputFacts, aNameTypedForSeveralEntitiesRenamesAllInOneStep) {
    select({"crate", "sign"});
    press("F2");
    hands.type("box");
    hands.key(Key::Enter);
    hands.rest(2);
    EXPECT_EQ(count("box"), 2);
    EXPECT_EQ(workspace.undo.size(), 1u);
    press("Ctrl+Z");
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(InputFacts, ofManyThousandRowsOnlyThoseInSightAreDrawn) {
    std::string text = R"({"format": 1, "entities": [)";
    for (int i = 0; i < 20000; ++i) {
        text += i == 0 ? "" : ",";
        text += R"({"id": ")" + hexText(static_cast<std::uint64_t>(i) + 1) + R"(", "name": "e)" +
                std::to_string(i) + R"(", "components": {}})";
    }
    putFile("scenes/many.scene.json", text + "]}");
    ASSERT_TRUE(workspace.open("scenes/many.scene.json").ok());
    hands.rest(3);
    ASSERT_EQ(workspace.document.objectCount(), 20000u);
    const auto rowsShown = [&] {
        int rows = 0;
        for (const auto& [path, widget] : window.widgets().all()) rows += startsWith(path, "Scene/e") ? 1 : 0;
        return rows / 3;  // each entity has three widgets: the row, its eye and its lock
    };
    EXPECT_GT(rowsShown(), 5);
    EXPECT_LT(rowsShown(), 60);
    EXPECT_LT(ImGui::GetDrawData()->TotalVtxCount, 60000);
    // The last entity can still be found by the filter.
    press("Ctrl+F");
    hands.type("e19999");
    hands.rest(2);
    EXPECT_TRUE(shown("Scene/e19999"));
    EXPECT_EQ(rowsShown(), 1);
}

TEST_F(InputFacts, aRowThatIsRenamedComesIntoSight) {
    // The panel is hidden behind another one and the filter hides the row.
    press("Ctrl+F");
    hands.type("lamp");
    hands.key(Key::Enter);
    hands.rest();
    press("Alt+1");
    hands.click("Tab/Inspector");
    workspace.document.selection.set({named("sign")});
    hands.rest(2);
    ASSERT_FALSE(shown("Scene/sign"));
    press("F2");
    hands.rest(3);
    hands.type("board");
    hands.key(Key::Enter);
    hands.rest();
    EXPECT_TRUE(named("board"));
    EXPECT_TRUE(shown("Scene/board"));
}

TEST_F(InputFacts, whatAFieldMeansIsSaidWhenTheMouseRests) {
    select({"crate"});
    hands.moveTo(hands.middleOf("Inspector/BoxCollider/width/label"));
    hands.rest(3);
    const int quiet = ImGui::GetDrawData()->CmdListsCount;
    hands.rest(90);
    const int said = ImGui::GetDrawData()->CmdListsCount;
    hands.moveTo({640.0f, 5.0f});
    hands.rest(3);
    EXPECT_GT(std::max(quiet, said), ImGui::GetDrawData()->CmdListsCount) << "a window of words";
}

}  // namespace
}  // namespace plumb::editor::ui
