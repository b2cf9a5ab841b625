// Messages that mention keys use the user's key bindings.

#include "editor/model/input/key_words.hpp"

#include "editor/model/actions.hpp"
#include "editor/model/assets/input_map_edit.hpp"
#include "editor/model/cost/scene_physics_edit.hpp"
#include "platform/image_file.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

/// A user with Ctrl+U for undo, F12 for saving, and no key for playing.
class KeyWords : public EditorFixture {
protected:
    KeyWords() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        KeyBindings& keys = workspace.settings.keys;
        keys.bind(*findAction("edit.undo"), {Key::U, true});
        keys.bind(*findAction("file.save"), {Key::F12});
        keys.unbind(*findAction("run.play"));
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(KeyWords, areTheKeysOfTheActionOrElseItsName) {
    EXPECT_EQ(keysFor(workspace, "edit.undo"), "Ctrl+U");
    EXPECT_EQ(keysFor(workspace, "run.play"), "Play");
    workspace.settings.keys.resetAll();
    EXPECT_EQ(keysFor(workspace, "edit.undo"), "Ctrl+Z");
}

TEST_F(KeyWords, ofAnActionThatDoesNotExistAreItsName) {
    EXPECT_EQ(keysFor(workspace, "edit.gone"), "edit.gone");
    EXPECT_EQ(keysFor(workspace, ""), "");
    EXPECT_EQ(withKeys(workspace, "press {edit.gone} or {edit.undo}"), "press edit.gone or Ctrl+U");
}

TEST_F(KeyWords, areInTheNoticeOfANewPrefab) {
    workspace.document.selection.set({named("crate")});
    runAction(workspace, "entity.makePrefab");
    hands.rest(3);
    hands.click("MakePrefab/Make");
    EXPECT_EQ(workspace.notice, "Created prefabs/crate.prefab.json; press Ctrl+U to undo");
}

TEST_F(KeyWords, areInTheNoticeOfARenamedAction) {
    putFile("project.json", R"({"format": 1, "input": {"actions": {"Dash": ["X"]}}})");
    putFile("scenes/menu.scene.json", R"({"format": 1, "entities": [
        {"id": "0000000000000001", "components": {"ToggleKey": {"action": "Dash"}}}]})");
    InputMapEdit edit{workspace};
    edit.refresh();
    ASSERT_TRUE(edit.rename(InputMapEdit::Kind::Action, "Dash", "Rush").ok());
    EXPECT_EQ(workspace.notice, "Renamed Dash to Rush, also in 1 place of 1 file; press Ctrl+U to undo");
}

TEST_F(KeyWords, areInTheNoticesOfDeletedFilesAndUnsavedScenes) {
    putFile("assets/hero.png", *encodePng(Image{2, 2, std::vector<std::uint8_t>(16, 255)}));
    putFile("scenes/other.scene.json", kSceneText);
    hands.click("Tab/Assets");
    hands.rest(40);
    hands.click("Assets/folder/assets");
    hands.rest(2);
    hands.click("Assets/assets/hero.png");
    hands.key(Key::Delete);
    hands.rest(3);
    EXPECT_EQ(window.widgets().find("Delete/question")->value,
              "Delete assets/hero.png?  Ctrl+U restores it.");
    hands.click("Delete/Keep");
    hands.rest(2);

    runAction(workspace, "entity.create");
    hands.click("Assets/folder/scenes");
    hands.rest(2);
    hands.click("Assets/scenes/other.scene.json");
    hands.clickAt(hands.middleOf("Assets/scenes/other.scene.json"));
    EXPECT_EQ(workspace.notice, "Save the open scene first (F12), then open scenes/other.scene.json");
}

TEST_F(KeyWords, areInTheHintsOfTools) {
    workspace.settings.keys.bind(*findAction("edit.delete"), {Key::Q, true});
    hands.key(Key::C);
    EXPECT_NE(workspace.notice.find("to add a corner; Ctrl+Q removes it."), std::string::npos)
        << workspace.notice;
    workspace.notice.clear();
    hands.rest(2);
    EXPECT_NE(window.widgets().find("Status/notice")->value.find("Ctrl+Q removes it."), std::string::npos);
    for (const ToolRow& row : toolTable()) {
        EXPECT_EQ(withKeys(workspace, row.hint).find('{'), std::string::npos) << row.name;
        EXPECT_EQ(row.hint.find("Del"), std::string_view::npos) << row.name;
    }
}

TEST_F(KeyWords, areInTheNoticeOfAnAppliedAdvice) {
    applyRemedy(workspace, qualityRemedy(3), ScenePhysics{});
    EXPECT_EQ(workspace.notice, "Use quality 3; press Ctrl+U to undo");
}

}  // namespace
}  // namespace plumb::editor::ui
