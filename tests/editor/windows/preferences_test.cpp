#include <imgui.h>

#include "editor/model/actions.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

class Preferences : public EditorFixture {
protected:
    Preferences() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        hands.key(Key::Comma, {.control = true});
        hands.rest(2);
    }

    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        const WidgetMap::Widget* found = window.widgets().find(widget);
        return found == nullptr ? "not on the screen" : found->value;
    }
    void openKeys(std::string_view search) {
        hands.click("Preferences/Keys");
        hands.click("Preferences/Keys/search");
        hands.type(search);
        hands.rest();
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(Preferences, theThemeIsChosenAndSeenAtOnce) {
    const ImVec4 dark = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
    hands.click("Preferences/theme/light");
    hands.rest(2);
    EXPECT_EQ(workspace.settings.theme, Theme::Light);
    EXPECT_GT(ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x, dark.x + 0.5f);
    hands.click("Preferences/theme/dark");
    hands.rest(2);
    EXPECT_EQ(ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x, dark.x);
}

TEST_F(Preferences, theScaleCountsWhenTheSliderIsLetGoAndComesBackExactly) {
    const ImGuiStyle before = ImGui::GetStyle();
    const Vec2 grab = hands.middleOf("Preferences/scale");
    hands.moveTo(grab), hands.rest(), hands.press();
    hands.moveTo(grab + Vec2{20.0f, 0.0f}), hands.rest(2);
    EXPECT_EQ(workspace.settings.scale, 1.0f) << "not while it is in the hand";
    hands.release(), hands.rest(3);
    const float chosen = workspace.settings.scale;
    EXPECT_GT(chosen, 1.5f);
    EXPECT_FLOAT_EQ(ImGui::GetStyle().ScrollbarSize, std::floor(before.ScrollbarSize * chosen));
    hands.click("Preferences/scale/100");
    hands.rest(3);
    EXPECT_EQ(workspace.settings.scale, 1.0f);
    EXPECT_EQ(ImGui::GetStyle().ScrollbarSize, before.ScrollbarSize);
    EXPECT_EQ(ImGui::GetStyle().ItemSpacing.x, before.ItemSpacing.x);
}

TEST_F(Preferences, aKeyIsChosenByPressingItAndShownInTheMenus) {
    openKeys("Frame all");
    ASSERT_EQ(valueOf("Preferences/Keys/view.all"), "Home, Shift+F");
    EXPECT_EQ(window.widgets().find("Preferences/Keys/edit.undo"), nullptr) << "the search leaves it out";
    hands.click("Preferences/Keys/view.all");
    EXPECT_EQ(valueOf("Preferences/Keys/view.all"), "listening");
    hands.key(Key::J, {.control = true});
    EXPECT_EQ(valueOf("Preferences/Keys/view.all"), "Ctrl+J, Shift+F");
    const Action& all = *findAction("view.all");
    EXPECT_EQ(workspace.settings.keys.labelOf(all), "Frame all  (Ctrl+J)");
    hands.click("Preferences/Keys/view.all/reset");
    EXPECT_EQ(valueOf("Preferences/Keys/view.all"), "Home, Shift+F");
}

TEST_F(Preferences, keysThatAreTakenAreNamedAndTakenOnlyWhenOneSaysSo) {
    openKeys("Undo");
    hands.click("Preferences/Keys/edit.undo");
    hands.key(Key::D, {.control = true});
    EXPECT_EQ(valueOf("Preferences/Keys/conflict"), "Ctrl+D is already assigned to \"Edit: Duplicate\".");
    EXPECT_FALSE(workspace.settings.keys.anyChanged());
    hands.click("Preferences/Keys/Leave");
    EXPECT_EQ(valueOf("Preferences/Keys/edit.undo"), "Ctrl+Z");

    hands.click("Preferences/Keys/edit.undo");
    hands.key(Key::D, {.control = true});
    hands.click("Preferences/Keys/Take");
    EXPECT_EQ(valueOf("Preferences/Keys/edit.undo"), "Ctrl+D");
    EXPECT_TRUE(workspace.settings.keys.of(*findAction("edit.duplicate")).empty());
    hands.click("Preferences/Close");

    // The shortcut now triggers its new action.
    workspace.document.selection.set({named("crate")});
    hands.key(Key::Delete);
    ASSERT_FALSE(named("crate"));
    hands.key(Key::Z, {.control = true});
    EXPECT_FALSE(named("crate"));
    hands.key(Key::D, {.control = true});
    EXPECT_TRUE(named("crate"));
}

TEST_F(Preferences, escapeKeepsTheKeysAndNoneRemovesThem) {
    openKeys("Undo");
    hands.click("Preferences/Keys/edit.undo");
    hands.key(Key::Escape);
    EXPECT_EQ(valueOf("Preferences/Keys/edit.undo"), "Ctrl+Z") << "and the window stays";
    hands.click("Preferences/Keys/edit.undo/none");
    EXPECT_EQ(valueOf("Preferences/Keys/edit.undo"), "");
    hands.click("Preferences/Keys/Reset all");
    EXPECT_EQ(valueOf("Preferences/Keys/edit.undo"), "Ctrl+Z");
}

TEST_F(Preferences, whatTheRightButtonDoesIsChosenForAllProjects) {
    hands.click("Preferences/Editing");
    hands.click("Preferences/right/erases");
    hands.rest();
    EXPECT_TRUE(workspace.tiles.rightErases);
    EXPECT_TRUE(workspace.settings.rightErases);
}

}  // namespace
}  // namespace plumb::editor::ui
