// Several selected instances and their prefabs.

#include "editor/model/prefabs/prefab_group.hpp"

#include "editor/model/actions.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "editor/model/prefabs/override_list.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

class PrefabGroups : public EditorFixture {
protected:
    /// Creates two crates of one prefab and a hero of another.
    PrefabGroups() {
        first = *makePrefab(workspace, {named("crate")}, prefabPath("crate"));
        hero = *makePrefab(workspace, {named("player")}, prefabPath("hero"));
        EXPECT_TRUE(addInstance(workspace.prefabs(), prefabPath("crate"), {10.0f, 20.0f}).ok());
        second = workspace.document.selection.all().front();
        workspace.undo.clear();
    }
    [[nodiscard]] float widthOf(ObjectId id) const {
        const World& world = workspace.document.world;
        return world.get<BoxCollider>(workspace.document.find(id)).width;
    }
    void setWidth(ObjectId id, float width) {
        workspace.document.world.get<BoxCollider>(workspace.document.find(id)).width = width;
        ++workspace.document.sceneRevision;
    }
    [[nodiscard]] std::size_t ownValues(ObjectId id) { return overrideList(workspace.prefabs(), id).size(); }
    [[nodiscard]] PrefabScope width() const {
        return {&workspace.document.types().of<BoxCollider>(), "width"};
    }

    ObjectId first, second, hero;
};

TEST_F(PrefabGroups, overridesOfAllSelectedInstancesAreCountedAndMarked) {
    setWidth(first, 50.0f);
    setWidth(hero, 60.0f);
    const PrefabGroup group = prefabGroup(workspace.prefabs(), {first, second, hero});
    EXPECT_EQ(group.parts, 3u);
    EXPECT_EQ(group.prefabs, (std::vector{prefabPath("crate"), prefabPath("hero")}));
    EXPECT_EQ(group.changed, 2u);
    EXPECT_TRUE(group.overrides.isPart);
    EXPECT_TRUE(group.overrides.has(*width().type, "width"))
        << "also where the last one has no value of its own";
    EXPECT_TRUE(group.whyNotApply.empty());
    const PrefabGroup mixed = prefabGroup(workspace.prefabs(), {first, named("sign")});
    EXPECT_EQ(mixed.parts, 1u);
    EXPECT_FALSE(mixed.overrides.isPart) << "of the sign no prefab says what it should be";
}

TEST_F(PrefabGroups, revertingRemovesTheOverridesOfAllInstances) {
    const float before = widthOf(second);
    setWidth(first, 50.0f);
    setWidth(second, 51.0f);
    workspace.document.selection.set({first, second});
    workspace.revertToPrefab();
    EXPECT_EQ(widthOf(first), before);
    EXPECT_EQ(widthOf(second), before);
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(PrefabGroups, equalOverridesAreAppliedOnceToEachPrefab) {
    setWidth(first, 50.0f);
    setWidth(second, 50.0f);
    setWidth(hero, 60.0f);
    const std::string crate = fileText(prefabPath("crate"));
    workspace.document.selection.set({first, second, hero});
    workspace.applyToPrefab();
    EXPECT_NE(fileText(prefabPath("crate")).find("\"width\": 50"), std::string::npos) << workspace.notice;
    EXPECT_NE(fileText(prefabPath("hero")).find("\"width\": 60"), std::string::npos);
    for (const ObjectId id : {first, second, hero}) EXPECT_EQ(ownValues(id), 0u);
    EXPECT_EQ(workspace.undo.size(), 1u);
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(fileText(prefabPath("crate")), crate);
}

TEST_F(PrefabGroups, conflictingOverridesAreReportedAndNotApplied) {
    setWidth(first, 50.0f);
    setWidth(second, 51.0f);
    const std::string crate = fileText(prefabPath("crate"));
    workspace.document.selection.set({first, second});
    EXPECT_NE(prefabGroup(workspace.prefabs(), {first, second}).whyNotApply.find("differ"),
              std::string::npos);
    for (const PrefabScope& scope : {PrefabScope{}, PrefabScope{width().type}, width()}) {
        workspace.applyToPrefab(scope);
        EXPECT_NE(workspace.notice.find("2 selected instances"), std::string::npos) << workspace.notice;
        EXPECT_EQ(fileText(prefabPath("crate")), crate);
        EXPECT_EQ(workspace.undo.size(), 0u);
    }
    // One instance has no override: the override of the other is applied.
    workspace.document.selection.set({second});
    workspace.revertToPrefab();
    workspace.document.selection.set({first, second});
    workspace.applyToPrefab(width());
    EXPECT_EQ(widthOf(second), 50.0f) << "it follows";
}

class PrefabGroupWindow : public PrefabGroups {
protected:
    PrefabGroupWindow()
        : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}
    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        const auto* found = window.widgets().find(widget);
        return found == nullptr ? "not on the screen" : found->value;
    }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(PrefabGroupWindow, theBarShowsAllSelectedInstances) {
    setWidth(first, 50.0f);
    workspace.document.selection.set({first, second});
    hands.rest(2);
    EXPECT_EQ(valueOf("Inspector/prefab"), "1") << "though the last one is as its prefab says";
    EXPECT_EQ(valueOf("Inspector/BoxCollider/width/label"), "overridden");
    setWidth(second, 51.0f);
    hands.rest(2);
    EXPECT_EQ(valueOf("Inspector/prefab"), "2");
    EXPECT_NE(valueOf("Inspector/prefab/apply").find("differ"), std::string::npos);
    hands.click("Inspector/prefab/apply");
    EXPECT_EQ(workspace.undo.size(), 0u) << "it cannot be pressed";
    hands.click("Inspector/prefab/revert");
    hands.rest(2);
    EXPECT_EQ(valueOf("Inspector/prefab"), "0");
    EXPECT_EQ(widthOf(first), widthOf(second));
}

}  // namespace
}  // namespace plumb::editor
