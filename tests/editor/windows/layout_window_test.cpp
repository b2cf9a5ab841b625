#include <imgui.h>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

class LayoutWindow : public EditorFixture {
protected:
    LayoutWindow() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}

    [[nodiscard]] const PaneLayout& layout() const { return workspace.settings.layout; }
    [[nodiscard]] bool onScreen(std::string_view widget) const {
        return window.widgets().find(widget) != nullptr;
    }
    [[nodiscard]] AABB boxOf(std::string_view widget) const { return window.widgets().find(widget)->box; }
    void choose(std::initializer_list<const char*> menus) {
        for (const char* item : menus) hands.click(item), hands.rest();
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(LayoutWindow, aSplitterIsDraggedAndStoredAsAFractionOfTheWindow) {
    const float before = boxOf("Viewport").min.x;
    const Vec2 grab = hands.middleOf("Splitter/left");
    hands.drag(grab, grab + Vec2{128.0f, 0.0f});
    EXPECT_NEAR(boxOf("Viewport").min.x, before + 128.0f, 2.0f);
    EXPECT_NEAR(layout().size(Edge::Left), 0.28f, 0.005f);
    const Vec2 up = hands.middleOf("Splitter/bottom");
    const float height = boxOf("Viewport").size().y;
    hands.drag(up, up - Vec2{0.0f, 60.0f});
    EXPECT_NEAR(boxOf("Viewport").size().y, height - 60.0f, 2.0f);
    EXPECT_EQ(workspace.undo.size(), 0u) << "how it looks is no edit";
}

TEST_F(LayoutWindow, theTreeShowsWholeRows) {
    for (int i = 0; i < 60; ++i) runAction(workspace, "entity.create");
    const float bottom = boxOf("Splitter/left").max.y - 8.0f;  // px: lower edge of the tree
    for (const char* name : {"camera", "ground"}) {
        workspace.document.selection.set({named(name)});
        hands.rest(3);
        for (const auto& [path, widget] : window.widgets().all()) {
            if (!startsWith(path, "Scene/")) continue;
            EXPECT_LE(widget.box.max.y, bottom) << path << ", " << name;
        }
    }
}

TEST_F(LayoutWindow, theMenuOfATabMovesItAndClosesItAndTheMenuViewOpensItAgain) {
    hands.clickAt(hands.middleOf("Tab/History"), MouseButton::Right);
    hands.rest();
    hands.click("Tab/History/Left");
    EXPECT_EQ(layout().dockOf("History"), Dock::Left);
    EXPECT_TRUE(layout().isSeen("History"));
    EXPECT_FALSE(onScreen("Scene/crate")) << "the tree is behind it";
    hands.click("Tab/Scene");
    EXPECT_TRUE(onScreen("Scene/crate"));

    hands.clickAt(hands.middleOf("Tab/History"), MouseButton::Right);
    hands.rest();
    hands.click("Tab/History/Close");
    EXPECT_FALSE(layout().isOpen("History"));
    EXPECT_FALSE(onScreen("Tab/History"));
    choose({"Menu/View", "Menu/View/Panels", "Menu/View/Panels/History"});
    EXPECT_TRUE(layout().isSeen("History"));
    EXPECT_EQ(layout().dockOf("History"), Dock::Left) << "where it was";
}

TEST_F(LayoutWindow, aTabIsDraggedToAnotherPaneAndNextToAnotherTab) {
    hands.drag(hands.middleOf("Tab/Console"), boxOf("Tab/Inspector").center() + Vec2{0.0f, 200.0f});
    EXPECT_EQ(layout().dockOf("Console"), Dock::Right);
    EXPECT_TRUE(layout().isSeen("Console"));
    hands.drag(hands.middleOf("Tab/Console"), hands.middleOf("Tab/Tileset"));
    const std::vector<std::string>& tabs = layout().pane(Dock::Bottom).tabs;
    const auto at = std::find(tabs.begin(), tabs.end(), "Console");
    ASSERT_NE(at, tabs.end());
    ASSERT_NE(at + 1, tabs.end());
    EXPECT_EQ(*(at + 1), "Tileset");
}

TEST_F(LayoutWindow, aTabDroppedOnTheViewportStaysInItsPane) {
    const PaneLayout before = layout();
    hands.drag(hands.middleOf("Tab/Inspector"), hands.middleOf("Viewport"));
    EXPECT_EQ(layout(), before);
}

TEST_F(LayoutWindow, droppingATabAtTheRightOfTheBottomSplitsIt) {
    const AABB scene = boxOf("Viewport");
    hands.drag(hands.middleOf("Tab/Console"), {scene.max.x - 20.0f, 660.0f});
    EXPECT_EQ(layout().dockOf("Console"), Dock::BottomRight);
    hands.rest();
    const Vec2 bar = hands.middleOf("Splitter/split");
    hands.drag(bar, bar - Vec2{60.0f, 0.0f});
    EXPECT_LT(layout().size(Edge::Split), 0.46f);
}

TEST_F(LayoutWindow, tabHidesThePanelsAndBelongsToWhatIsTypedInto) {
    const Vec2 before = boxOf("Viewport").size();
    hands.key(Key::Tab);
    hands.rest();
    EXPECT_FALSE(onScreen("Scene/crate"));
    EXPECT_FALSE(onScreen("Tab/Console"));
    EXPECT_EQ(boxOf("Viewport").size().x, 1280.0f);
    hands.key(Key::Tab);
    hands.rest();
    EXPECT_EQ(boxOf("Viewport").size(), before);

    hands.click("Scene/filter");
    hands.key(Key::Tab);
    hands.rest();
    EXPECT_TRUE(onScreen("Scene/crate"));
}

TEST_F(LayoutWindow, presetsAreSelectedByKeysAndByTheMenu) {
    hands.key(Key::Digit1, {.alt = true});
    hands.rest();
    EXPECT_TRUE(layout().isSeen("Tiles"));
    EXPECT_EQ(layout().dockOf("Inspector"), Dock::Left);
    hands.key(Key::Digit3, {.alt = true});
    hands.rest();
    EXPECT_EQ(layout().dockOf("History"), Dock::BottomRight);
    EXPECT_TRUE(layout().pane(Dock::Left).tabs.empty());
    choose({"Menu/View", "Menu/View/Layout", "Menu/View/Layout/Logic"});
    EXPECT_EQ(layout().dockOf("Scene"), Dock::Left);
    EXPECT_TRUE(layout().isSeen("Console"));
}

TEST_F(LayoutWindow, aLayoutIsSavedUnderANameLoadedAndDeleted) {
    hands.key(Key::Digit3, {.alt = true});
    hands.rest();
    const PaneLayout mine = layout();
    choose({"Menu/View", "Menu/View/Layout", "Menu/View/Layout/Save layout as..."});
    hands.rest();
    hands.type("Evening");
    hands.click("Layout/Save");
    ASSERT_EQ(workspace.settings.layouts.size(), 1u);
    hands.key(Key::Digit2, {.alt = true});
    hands.rest();
    EXPECT_NE(layout(), mine);
    choose({"Menu/View", "Menu/View/Layout", "Menu/View/Layout/Evening"});
    EXPECT_EQ(layout(), mine);
    choose({"Menu/View", "Menu/View/Layout", "Menu/View/Layout/Delete layout",
            "Menu/View/Layout/Delete layout/Evening"});
    EXPECT_TRUE(workspace.settings.layouts.empty());
}

TEST_F(LayoutWindow, tabsThatDoNotFitAreInAList) {
    for (const PanelRow& row : panelTable()) workspace.settings.layout.move(row.title, Dock::Left);
    workspace.settings.layout.show("History");
    hands.rest(2);
    EXPECT_TRUE(onScreen("Tab/History")) << "the one in front always has its tab";
    ASSERT_TRUE(onScreen("Tab/more 0"));
    EXPECT_FALSE(onScreen("Tab/Animation"));
    choose({"Tab/more 0", "Tab/Animation"});
    EXPECT_TRUE(layout().isSeen("Animation"));
    EXPECT_TRUE(onScreen("Tab/Animation"));
}

TEST_F(LayoutWindow, theBrushShowsTheTilesPanelEvenIfItIsClosed) {
    workspace.settings.layout.close("Tiles");
    hands.rest();
    hands.key(Key::B);
    hands.rest();
    EXPECT_TRUE(layout().isSeen("Tiles"));
    hands.key(Key::Q);
    hands.rest();
    EXPECT_FALSE(layout().isOpen("Tiles"));
    EXPECT_TRUE(layout().isSeen("Console"));
}

TEST_F(LayoutWindow, aSmallWindowShowsThePanesAndALargerInterfaceTakesMoreRoom) {
    workspace.settings.scale = 2.0f;
    hands.rest(3);
    EXPECT_GT(boxOf("Tab/Inspector").size().y, 50.0f);
    EXPECT_GT(boxOf("Viewport").size().x, 100.0f);
    EXPECT_GT(boxOf("Viewport").size().y, 100.0f);
}

}  // namespace
}  // namespace plumb::editor::ui
