// Creating prefabs from entities of the scene, and the list of overrides of an instance.

#include "editor/model/prefabs/make_prefab.hpp"

#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/prefabs/override_list.hpp"
#include "scene/components/joints/distance_joint.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/world_transform.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

class MakingPrefabs : public EditorFixture {
protected:
    [[nodiscard]] const World& world() const { return workspace.document.world; }
    [[nodiscard]] EntityId entity(std::string_view name) const {
        return workspace.document.find(named(name));
    }
    /// Saves and opens the scene again, like after a restart of the program.
    void reopen() {
        ASSERT_TRUE(workspace.save().ok());
        ASSERT_TRUE(workspace.open(kScene).ok());
    }
    [[nodiscard]] bool fileIsThere(std::string_view path) const {
        return std::filesystem::exists(workspace.project.root / path);
    }
};

TEST_F(MakingPrefabs, anEntityWithItsChildrenBecomesAnEqualInstance) {
    const std::string path = prefabPath("hero");
    const Result<ObjectId> made = makePrefab(workspace, {named("player")}, path);
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(*made, named("player"));
    EXPECT_TRUE(world().has<PrefabInstance>(entity("player")));
    EXPECT_TRUE(world().has<PrefabPart>(entity("lamp")));
    EXPECT_EQ(positionOf(named("player")), (Vec2{40.0f, 100.0f}));
    EXPECT_EQ(overrideList(workspace.prefabs(), named("lamp")).size(), 0u) << "it is as the prefab says";
    EXPECT_EQ(workspace.undo.size(), 1u);
    const std::string prefab = fileText(path);
    EXPECT_EQ(prefab.find("[40, 100]"), std::string::npos) << "where it stands is its own";
    EXPECT_NE(prefab.find("\"lamp\""), std::string::npos);
    EXPECT_NE(prefab.find("\"strength\": 3"), std::string::npos) << "also what no component knows";
    const std::string scene = workspace.text();
    EXPECT_EQ(scene.find("\"lamp\""), std::string::npos) << "the scene says only what differs";
    reopen();
    EXPECT_EQ(workspace.text(), scene);
    EXPECT_EQ(positionOf(named("lamp")), (Vec2{10.0f, -10.0f}));
    EXPECT_EQ(parentOf(world(), entity("lamp")), entity("player"));
}

TEST_F(MakingPrefabs, undoDeletesTheFileAndRestoresTheBytes) {
    const std::string path = prefabPath("hero");
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, path).ok());
    const std::string prefab = fileText(path);
    const std::string scene = workspace.text();
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(workspace.undo.undo());
        EXPECT_EQ(workspace.text(), kSceneText);
        EXPECT_FALSE(fileIsThere(path));
        ASSERT_TRUE(workspace.undo.redo());
        EXPECT_EQ(workspace.text(), scene);
        EXPECT_EQ(fileText(path), prefab);
    }
}

TEST_F(MakingPrefabs, referencesToAPartStayValid) {
    World& changed = workspace.document.world;
    changed.get<Camera>(entity("camera")).follow = entity("lamp");
    auto& joint = changed.add<DistanceJoint>(entity("lamp"));
    joint.other = entity("player");
    auto& outwards = changed.add<DistanceJoint>(entity("player"));
    outwards.other = entity("crate");
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    EXPECT_EQ(fileText(prefabPath("hero")).find("0000000000000004"), std::string::npos)
        << "the prefab cannot know the crate";
    reopen();
    EXPECT_EQ(world().get<Camera>(entity("camera")).follow, entity("lamp")) << "from outside";
    EXPECT_EQ(world().get<DistanceJoint>(entity("lamp")).other, entity("player")) << "inside";
    EXPECT_EQ(world().get<DistanceJoint>(entity("player")).other, entity("crate")) << "out of it: its own";
}

TEST_F(MakingPrefabs, severalEntitiesGetANewCommonParentFirst) {
    const Result<ObjectId> made = makePrefab(workspace, {named("crate"), named("sign")}, prefabPath("pair"));
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(workspace.undo.size(), 1u);
    const Vec2 crate = worldPose(world(), entity("crate")).position;
    EXPECT_EQ(crate, (Vec2{200.0f, 64.0f}));
    reopen();
    EXPECT_EQ(worldPose(world(), entity("crate")).position, crate);
    EXPECT_EQ(parentOf(world(), entity("sign")), workspace.document.find(*made));
}

TEST_F(MakingPrefabs, aNestedInstanceStaysAnInstanceInThePrefab) {
    ASSERT_TRUE(makePrefab(workspace, {named("crate")}, prefabPath("crate")).ok());
    const Result<ObjectId> made = makePrefab(workspace, {named("crate"), named("sign")}, prefabPath("pair"));
    ASSERT_TRUE(made.ok());
    EXPECT_NE(fileText(prefabPath("pair")).find("prefabs/crate.prefab.json"), std::string::npos);
    EXPECT_EQ(overrideList(workspace.prefabs(), *made).size(), 0u);
    reopen();
    EXPECT_EQ(worldPose(world(), entity("crate")).position, (Vec2{200.0f, 64.0f}));
    // Changes of the inner prefab appear in instances of the outer one.
    putFile(prefabPath("crate"), [&] {
        std::string text = fileText(prefabPath("crate"));
        return text.replace(text.find("31"), 2, "77");
    }());
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_EQ(world().get<BoxCollider>(entity("crate")).width, 77.0f);
}

TEST_F(MakingPrefabs, aPrefabOfAnInstanceIsAVariantOfIt) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    workspace.document.world.get<BoxCollider>(entity("player")).width = 99.0f;
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("bighero")).ok());
    const std::string variant = fileText(prefabPath("bighero"));
    EXPECT_NE(variant.find("prefabs/hero.prefab.json"), std::string::npos);
    EXPECT_NE(variant.find("99"), std::string::npos);
    EXPECT_EQ(overrideList(workspace.prefabs(), named("player")).size(), 0u);
    reopen();
    EXPECT_EQ(world().get<BoxCollider>(entity("player")).width, 99.0f);
    EXPECT_EQ(positionOf(named("lamp")), (Vec2{10.0f, -10.0f}));
    workspace.undo.jumpTo(0);
}

TEST_F(MakingPrefabs, entitiesThatCannotBecomeAPrefabAreReportedAndNotChanged) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    const std::string before = workspace.text();
    const std::size_t steps = workspace.undo.size();
    EXPECT_FALSE(makePrefab(workspace, {named("crate")}, prefabPath("hero")).ok()) << "there is such a file";
    EXPECT_FALSE(makePrefab(workspace, {named("crate")}, prefabPath("")).ok());
    EXPECT_FALSE(makePrefab(workspace, {named("crate")}, "../outside.prefab.json").ok());
    EXPECT_FALSE(makePrefab(workspace, {named("lamp")}, prefabPath("part")).ok()) << "a part of another one";
    EXPECT_FALSE(makePrefab(workspace, {}, prefabPath("nothing")).ok());
    EXPECT_EQ(workspace.text(), before);
    EXPECT_EQ(workspace.undo.size(), steps);
}

TEST_F(MakingPrefabs, eachOverrideIsListedAndCanBeRevertedOrApplied) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    const PrefabEdit edit = workspace.prefabs();
    ASSERT_TRUE(addInstance(edit, prefabPath("hero"), {300.0f, 0.0f}).ok());
    const ObjectId second = workspace.document.selection.all().back();
    World& changed = workspace.document.world;
    changed.get<BoxCollider>(entity("player")).width = 20.0f;
    changed.get<Transform>(entity("lamp")).position = {1.0f, 2.0f};
    changed.remove<RigidBody>(entity("player"));
    const std::vector<OverrideRow> rows = overrideList(edit, named("player"));
    ASSERT_EQ(rows.size(), 3u);
    const auto rowOf = [&](std::string_view field) {
        for (const OverrideRow& row : rows) {
            if (row.type->name == field || row.field == field) return row;
        }
        ADD_FAILURE() << field;
        return OverrideRow{};
    };
    EXPECT_EQ(rowOf("width").prefab, "16");
    EXPECT_EQ(rowOf("width").here, "20");
    EXPECT_EQ(rowOf("position").entity, "lamp");
    EXPECT_EQ(rowOf("RigidBody").here, "removed");

    EXPECT_TRUE(revertOverride(edit, rowOf("position")));
    EXPECT_EQ(positionOf(named("lamp")), (Vec2{10.0f, -10.0f}));
    ASSERT_TRUE(applyToPrefab(edit, rowOf("width").object, rowOf("width").scope()).ok());
    EXPECT_EQ(world().get<BoxCollider>(workspace.document.find(second)).width, 20.0f) << "others follow";
    EXPECT_EQ(overrideList(edit, named("player")).size(), 1u);
}

TEST_F(MakingPrefabs, aRemovedPartIsListedAndCanBeRestored) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    workspace.document.selection.set({named("lamp")});
    ASSERT_TRUE(runAction(workspace, "edit.delete"));
    const std::vector<OverrideRow> rows = overrideList(workspace.prefabs(), named("player"));
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].entity, "lamp");
    EXPECT_TRUE(revertOverride(workspace.prefabs(), rows[0]));
    EXPECT_EQ(positionOf(named("lamp")), (Vec2{10.0f, -10.0f}));
    EXPECT_EQ(overrideList(workspace.prefabs(), named("player")).size(), 0u);
}

TEST_F(MakingPrefabs, inTheWindowAPrefabIsNamedAndItsOverridesAreReverted) {
    LogBook log;
    ui::EditorWindow window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"};
    ui::Hands hands{window};
    hands.click("Scene/crate");
    hands.clickAt(hands.middleOf("Scene/crate"), MouseButton::Right);
    hands.click("Scene/menu/Make prefab...");
    hands.rest(2);
    hands.type("box");
    hands.key(Key::Enter);
    hands.rest(2);
    ASSERT_TRUE(fileIsThere(prefabPath("box")));
    workspace.document.world.get<BoxCollider>(entity("crate")).width = 50.0f;
    ++workspace.document.sceneRevision;
    ASSERT_TRUE(runAction(workspace, "entity.overrides"));
    hands.rest(3);
    ASSERT_NE(window.widgets().find("Overrides/0"), nullptr);
    EXPECT_EQ(window.widgets().find("Overrides/0")->value, "crate BoxCollider.width");
    hands.click("Overrides/0/revert");
    hands.rest(2);
    EXPECT_EQ(world().get<BoxCollider>(entity("crate")).width, 31.0f);
    EXPECT_EQ(window.widgets().find("Overrides/0"), nullptr);
    hands.click("Overrides/Close");
}

TEST_F(MakingPrefabs, anEntityWhoseTransformIsNotAJsonObjectIsAcceptedOrRejected) {
    putFile(kScene, R"({"format": 1, "effects": {}, "layers": [], "entities": [
        {"id": "a1", "name": "odd", "components": {"Transform": 5}}, 7]})");
    ASSERT_TRUE(workspace.open(kScene).ok());
    const Result<ObjectId> made = makePrefab(workspace, {named("odd")}, prefabPath("odd"));
    EXPECT_TRUE(made.ok() || !made.error().what.empty());
}

TEST_F(MakingPrefabs, aSceneWithAnEntityThatIsNotAJsonObjectIsRejected) {
    putFile(kScene, R"({"format": 1, "effects": {}, "layers": [], "entities": [
        {"id": "a1", "name": "whole", "components": {}}, {"id": nonsense}]})");
    ASSERT_TRUE(workspace.open(kScene).ok());
    const Result<ObjectId> made = makePrefab(workspace, {named("whole")}, prefabPath("whole"));
    ASSERT_FALSE(made.ok());
    EXPECT_FALSE(made.error().remedy.empty());
}

}  // namespace
}  // namespace plumb::editor
