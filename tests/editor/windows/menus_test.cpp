// Context menus, and which of their entries are enabled.

#include "editor/model/actions.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

class Menus : public EditorFixture {
protected:
    Menus() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}
    [[nodiscard]] bool shown(std::string_view widget) const {
        return window.widgets().find(widget) != nullptr;
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        EXPECT_TRUE(shown(widget)) << widget;
        return shown(widget) ? window.widgets().find(widget)->value : std::string{};
    }
    void nudgeRight(std::string_view name) {
        workspace.document.selection.set({named(name)});
        ASSERT_TRUE(runAction(workspace, "entity.right"));
        workspace.undo.endGesture();
    }
    void openMenuOf(std::string_view name) {
        hands.clickAt(hands.middleOf(std::string{"Scene/"} + std::string{name}), MouseButton::Right);
        hands.rest(2);
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(Menus, ofTheTreeHaveCutCopyPasteAndDuplicate) {
    openMenuOf("crate");
    hands.click("Scene/menu/Copy");
    openMenuOf("crate");
    hands.click("Scene/menu/Paste");
    EXPECT_EQ(workspace.document.objectCount(), 7u);
    openMenuOf("sign");
    hands.click("Scene/menu/Cut");
    EXPECT_FALSE(named("sign"));
    openMenuOf("player");
    hands.click("Scene/menu/Duplicate");
    EXPECT_EQ(workspace.document.objectCount(), 8u) << "with the lamp";
}

TEST_F(Menus, ofPlainEntitiesHaveNoPrefabEntries) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    openMenuOf("crate");
    EXPECT_TRUE(shown("Scene/menu/Make prefab..."));
    for (const char* line : {"Edit prefab", "Prefab overrides...", "Revert to prefab", "Apply to prefab"})
        EXPECT_FALSE(shown(std::string{"Scene/menu/"} + line)) << line;
    hands.key(Key::Escape);
    openMenuOf("player");
    for (const char* line : {"Edit prefab", "Prefab overrides...", "Revert to prefab", "Apply to prefab"})
        EXPECT_TRUE(shown(std::string{"Scene/menu/"} + line)) << line;
}

TEST_F(Menus, offerWaysToAndFromThePrefabOnlyWhereSomethingDiffers) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    ASSERT_TRUE(makePrefab(workspace, {named("crate")}, prefabPath("box")).ok());
    const auto can = [&](const char* action) { return findAction(action)->enabled(workspace); };
    workspace.document.selection.set({named("crate")});
    EXPECT_FALSE(can("entity.revert"));
    EXPECT_FALSE(can("entity.apply"));
    EXPECT_TRUE(can("entity.editPrefab"));

    nudgeRight("crate");
    EXPECT_FALSE(can("entity.revert")) << "where an instance stands is its own";
    nudgeRight("lamp");
    workspace.document.selection.set({named("player")});
    EXPECT_TRUE(can("entity.revert")) << "a part of it is elsewhere";
    EXPECT_TRUE(can("entity.apply"));
    workspace.document.selection.set({named("crate")});
    EXPECT_FALSE(can("entity.revert"));
    workspace.document.selection.set({named("crate"), named("player")});
    EXPECT_TRUE(can("entity.revert"));
    EXPECT_FALSE(can("entity.editPrefab")) << "which one?";
    hands.rest(2);
    EXPECT_EQ(window.widgets().find("Inspector/prefab/edit")->value, "several");
    hands.click("Inspector/prefab/edit");
    EXPECT_EQ(workspace.document.scenePath, kScene);

    ASSERT_TRUE(runAction(workspace, "entity.revert"));
    EXPECT_FALSE(can("entity.revert")) << "nothing is left of it";
    ASSERT_TRUE(runAction(workspace, "edit.undo"));
    EXPECT_TRUE(can("entity.revert"));
}

TEST_F(Menus, makePrefabProposesAFreeNameAndSaysWhatComesOfIt) {
    ASSERT_TRUE(makePrefab(workspace, {named("crate")}, prefabPath("crate")).ok());
    workspace.document.selection.set({named("crate")});
    runAction(workspace, "entity.makePrefab");
    hands.rest(3);
    EXPECT_EQ(valueOf("MakePrefab/name"), "crate2");
    EXPECT_EQ(valueOf("MakePrefab/kind"),
              "A variant of prefabs/crate.prefab.json: its file stores only the differences.");
    hands.click("MakePrefab/Make");
    hands.rest(2);
    runAction(workspace, "entity.makePrefab");
    hands.rest(3);
    EXPECT_EQ(valueOf("MakePrefab/name"), "crate3");
    hands.click("MakePrefab/Cancel");

    workspace.document.selection.set({named("sign"), named("crate")});
    runAction(workspace, "entity.makePrefab");
    hands.rest(3);
    EXPECT_EQ(valueOf("MakePrefab/kind"),
              "The entities are put below a new one. The instance inside stays an instance.");
    hands.click("MakePrefab/Cancel");
    workspace.document.selection.set({named("sign")});
    runAction(workspace, "entity.makePrefab");
    hands.rest(3);
    EXPECT_EQ(valueOf("MakePrefab/name"), "sign");
    EXPECT_EQ(valueOf("MakePrefab/kind"), "");
}

TEST_F(Menus, entityDuplicatesAndDeletesToo) {
    workspace.document.selection.set({named("crate")});
    hands.click("Menu/Entity");
    hands.rest(2);
    hands.click("Menu/Entity/Duplicate");
    hands.rest(2);
    EXPECT_EQ(workspace.document.objectCount(), 7u);
    hands.click("Menu/Entity");
    hands.rest(2);
    hands.click("Menu/Entity/Delete");
    hands.rest(2);
    EXPECT_EQ(workspace.document.objectCount(), 6u);
}

}  // namespace
}  // namespace plumb::editor::ui
