// Copying entities as text between scenes and between projects.

#include "editor/model/clipboard.hpp"

#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/components/joints/distance_joint.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/world_transform.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kEmpty = R"({"format": 1, "effects": {}, "layers": [], "entities": []})";
constexpr std::string_view kOther = "scenes/other.scene.json";

class Clipboards : public EditorFixture {
protected:
    Clipboards() {
        putFile(kOther, kEmpty);
        EXPECT_TRUE(writeFile(folder_.path / kOther, kEmpty).ok());
        EXPECT_TRUE(elsewhere.open(kOther).ok());
    }
    void copy(std::vector<ObjectId> ids) {
        workspace.document.selection.set(std::move(ids));
        ASSERT_TRUE(runAction(workspace, "edit.copy"));
    }
    static ObjectId namedIn(const Workspace& w, std::string_view name) {
        for (const ObjectId id : w.document.objects()) {
            if (w.document.nameOf(id) == name) return id;
        }
        return {};
    }

private:
    test::TemporaryFolder folder_;
    TypeRegistry otherTypes_ = engineTypes();
    AssetStore otherAssets_{folder_.path};
    PrefabLibrary otherPrefabs_{otherTypes_, folder_.path};

protected:
    Workspace elsewhere{otherTypes_, otherAssets_, {folder_.path}, &otherPrefabs_};
};

TEST_F(Clipboards, copiedEntitiesAreReadableText) {
    copy({named("player")});
    const Result<Json> json = parseJson(workspace.clipboard, "clipboard");
    ASSERT_TRUE(json.ok());
    EXPECT_NE(workspace.clipboard.find("\"BoxCollider\""), std::string::npos);
}

TEST_F(Clipboards, childrenTilesAndReferencesAreCopiedToOtherScenesAndProjects) {
    World& world = workspace.document.world;
    auto& joint = world.add<DistanceJoint>(workspace.document.find(named("lamp")));
    joint.other = workspace.document.find(named("player"));
    copy({named("player"), named("ground")});
    const std::string text = workspace.clipboard;
    ASSERT_TRUE(workspace.open(kOther).ok());
    for (Workspace* target : {&workspace, &elsewhere}) {
        Document& document = target->document;
        target->clipboard = text;
        ASSERT_TRUE(runAction(*target, "edit.paste"));
        EXPECT_EQ(document.objectCount(), 3u);
        EXPECT_EQ(target->undo.size(), 1u);
        const EntityId player = document.find(namedIn(*target, "player"));
        const EntityId lamp = document.find(namedIn(*target, "lamp"));
        const World& there = document.world;
        EXPECT_EQ(parentOf(there, lamp), player);
        EXPECT_EQ(there.get<DistanceJoint>(lamp).other, player);
        EXPECT_EQ(there.get<Transform>(player).position, (Vec2{40.0f, 100.0f}));
        const auto& layer = there.get<TileLayer>(document.find(namedIn(*target, "ground")));
        ASSERT_NE(there.tiles().find(layer.cells), nullptr);
        EXPECT_EQ(there.tiles().find(layer.cells)->width(), 4);
        EXPECT_NE(there.tiles().find(layer.cells)->at(0, 2), 0);
        ASSERT_TRUE(target->undo.undo());
        EXPECT_EQ(document.objectCount(), 0u);
    }
}

TEST_F(Clipboards, aCopiedInstanceKeepsItsPrefabAndItsOverrides) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    workspace.document.world.get<BoxCollider>(workspace.document.find(named("player"))).width = 77.0f;
    copy({named("player")});
    const std::string text = workspace.clipboard;
    ASSERT_TRUE(workspace.open(kOther).ok());
    workspace.clipboard = text;
    ASSERT_TRUE(runAction(workspace, "edit.paste"));
    const std::string scene = workspace.text();
    EXPECT_NE(scene.find("prefabs/hero.prefab.json"), std::string::npos);
    EXPECT_NE(scene.find("77"), std::string::npos);
    EXPECT_EQ(scene.find("\"lamp\""), std::string::npos) << "its parts are still parts";
}

TEST_F(Clipboards, anInstanceIsUnpackedIfItsPrefabIsMissing) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    workspace.document.world.get<BoxCollider>(workspace.document.find(named("player"))).width = 77.0f;
    copy({named("player")});
    elsewhere.clipboard = workspace.clipboard;
    ASSERT_TRUE(runAction(elsewhere, "edit.paste"));
    EXPECT_NE(elsewhere.notice.find("this project has no prefabs/hero.prefab.json"), std::string::npos)
        << elsewhere.notice;
    EXPECT_FALSE(elsewhere.selectsInstance());
    ASSERT_TRUE(elsewhere.save().ok());
    ASSERT_TRUE(elsewhere.open(kOther).ok());
    const World& there = elsewhere.document.world;
    const EntityId player = elsewhere.document.find(namedIn(elsewhere, "player"));
    const EntityId lamp = elsewhere.document.find(namedIn(elsewhere, "lamp"));
    ASSERT_TRUE(there.alive(lamp)) << "parts are saved like other entities";
    EXPECT_EQ(parentOf(there, lamp), player);
    EXPECT_EQ(there.get<Transform>(lamp).position, (Vec2{10.0f, -10.0f}));
    EXPECT_EQ(there.get<BoxCollider>(player).width, 77.0f);
}

TEST_F(Clipboards, aPartThatTheOtherProjectsPrefabDoesNotHaveIsUnpacked) {
    ASSERT_TRUE(makePrefab(workspace, {named("player")}, prefabPath("hero")).ok());
    copy({named("player")});
    ASSERT_TRUE(writeFile(elsewhere.project.root / prefabPath("hero"),
                          R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "hero",
                              "components": {"Transform": {}}}]})")
                    .ok());
    elsewhere.clipboard = workspace.clipboard;
    ASSERT_TRUE(runAction(elsewhere, "edit.paste"));
    EXPECT_TRUE(elsewhere.selectsInstance()) << "a prefab of this name is here";
    ASSERT_TRUE(elsewhere.save().ok());
    ASSERT_TRUE(elsewhere.open(kOther).ok());
    const EntityId lamp = elsewhere.document.find(namedIn(elsewhere, "lamp"));
    ASSERT_TRUE(elsewhere.document.world.alive(lamp));
    EXPECT_EQ(elsewhere.document.world.get<Transform>(lamp).position, (Vec2{10.0f, -10.0f}));
}

}  // namespace
}  // namespace plumb::editor
