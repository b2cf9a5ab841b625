#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

class EmptyStates : public EditorFixture {
protected:
    EmptyStates() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}
    [[nodiscard]] bool onScreen(std::string_view widget) const {
        return window.widgets().find(widget) != nullptr;
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(EmptyStates, everyEmptyPanelShowsAHint) {
    putFile("scenes/nothing.scene.json", R"({"format": 1, "entities": []})");
    log.clear();
    ASSERT_TRUE(workspace.open("scenes/nothing.scene.json").ok());
    log.clear();
    for (const PanelRow& row : panelTable()) {
        if (row.dock == Dock::Center) continue;
        workspace.settings.layout.show(row.title);
        hands.rest(2);
        const std::string title = row.title;
        const bool hasOwnFiles =
            // never empty: they list the scene files and the default keys
            title == "Assets" || title == "Input";
        EXPECT_TRUE(hasOwnFiles || onScreen(title + "/empty")) << title;
    }
}

TEST_F(EmptyStates, buttonsOfHintsWork) {
    hands.click("Inspector/empty/Create entity");
    EXPECT_EQ(workspace.document.objectCount(), 7u);
    EXPECT_FALSE(onScreen("Inspector/empty"));
    workspace.settings.layout.show("History");
    workspace.undo.undo();
    workspace.undo.clear();
    hands.rest(2);
    EXPECT_TRUE(onScreen("History/empty"));
}

TEST_F(EmptyStates, aSceneWithoutTilesOffersToAddALayer) {
    putFile("scenes/nothing.scene.json", R"({"format": 1, "entities": []})");
    ASSERT_TRUE(workspace.open("scenes/nothing.scene.json").ok());
    workspace.settings.layout.show("Tiles");
    hands.rest(2);
    hands.click("Tiles/empty/Add layer");
    hands.rest(2);
    EXPECT_FALSE(onScreen("Tiles/empty/Add layer"));
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(EmptyStates, withoutASceneTheMiddleOffersToOpenOne) {
    EXPECT_FALSE(workspace.open("scenes/gone.scene.json").ok());
    hands.rest(2);
    EXPECT_EQ(window.widgets().find("Inspector/empty")->value, "No scene is open.");
    EXPECT_EQ(window.widgets().find("Status/state")->value, "No scene") << "nothing is saved or selected";
    for (const std::string panel : {"Tiles", "Tileset"}) {
        workspace.settings.layout.show(panel);
        hands.rest(2);
        EXPECT_EQ(window.widgets().find(panel + "/empty")->value, "No scene is open.");
    }
    workspace.useTool("tool.brush");
    EXPECT_EQ(workspace.notice, "No scene is open");
    hands.click("Viewport/empty/Open scene...");
    hands.rest(2);
    EXPECT_TRUE(onScreen(std::string{"Finder/level.scene.json"}));
}

}  // namespace
}  // namespace plumb::editor::ui
