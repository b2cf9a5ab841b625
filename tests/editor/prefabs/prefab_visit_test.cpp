// Opening a prefab file for editing, and returning to the scene.

#include "editor/model/prefabs/prefab_visit.hpp"

#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/assets/hot_reload.hpp"
#include "editor/model/assets/place_asset.hpp"
#include "editor/model/clipboard.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/document/prefab_file.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "editor/model/safety/save_beside.hpp"
#include "editor/model/tree_edit.hpp"
#include "scene/components/joints/distance_joint.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/world_transform.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/editor/support/project_copy.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

const std::string kTorch = prefabPath("torch");
/// A prefab file as written by hand: the id of the root is not 1, parents and positions are omitted.
constexpr std::string_view kTorchText = R"({
  "format": 1,
  "entities": [
    {
      "id": "0000000000000077",
      "name": "torch",
      "components": {
        "Transform": {},
        "Sprite": {
          "width": 8,
          "height": 16
        },
        "DistanceJoint": {
          "other": "000000000000000a"
        },
        "FromTheFuture": {
          "strength": 3
        }
      }
    },
    {
      "id": "000000000000000a",
      "name": "flame",
      "components": {
        "Transform": {},
        "DistanceJoint": {
          "other": "0000000000000077"
        }
      }
    },
    {
      "id": "000000000000000b",
      "name": "glow",
      "parent": "000000000000000a",
      "components": {
        "Transform": {
          "position": [0, -8]
        }
      }
    }
  ]
}
)";
/// The lantern contains an instance of the torch; the big torch is a variant of the torch.
const std::string kLantern = prefabPath("lantern");
constexpr std::string_view kLanternText = R"({
  "format": 1,
  "entities": [
    {
      "id": "0000000000000001",
      "name": "lantern",
      "components": {
        "Transform": {}
      }
    },
    {
      "id": "00000000000000bb",
      "parent": "0000000000000001",
      "prefab": "prefabs/torch.prefab.json",
      "components": {
        "Transform": {
          "position": [0, 4]
        }
      }
    }
  ]
}
)";
const std::string kBig = prefabPath("big");
constexpr std::string_view kBigText = R"({
  "format": 1,
  "entities": [
    {
      "id": "0000000000000001",
      "name": "big",
      "prefab": "prefabs/torch.prefab.json",
      "components": {
        "Sprite": {
          "height": 32
        }
      },
      "children": {
        "000000000000000a": {
          "components": {
            "Transform": {
              "position": [0, -16]
            }
          }
        }
      }
    }
  ]
}
)";

class PrefabVisits : public EditorFixture {
protected:
    PrefabVisits() {
        putFile(kTorch, kTorchText);
        putFile(kLantern, kLanternText);
        putFile(kBig, kBigText);
        EXPECT_TRUE(addInstance(workspace.prefabs(), kTorch, {50.0f, 60.0f}).ok());
        EXPECT_TRUE(addInstance(workspace.prefabs(), kLantern, {90.0f, 60.0f}).ok());
        EXPECT_TRUE(workspace.save().ok());
    }
    [[nodiscard]] const World& world() const { return workspace.document.world; }
    [[nodiscard]] EntityId entity(std::string_view name) const {
        return workspace.document.find(named(name));
    }
    [[nodiscard]] int heightOf(std::string_view name) const {
        return world().get<Sprite>(entity(name)).height;
    }
    void setHeight(ObjectId id, int height) {
        const TypeInfo& type = workspace.document.types().of<Sprite>();
        std::vector<SetField::Change> changes;
        changes.push_back({id, FieldValue::of(height)});
        workspace.undo.push(std::make_unique<SetField>(type, *type.find("height"), std::move(changes)));
        workspace.undo.endGesture();
    }
    [[nodiscard]] ObjectId root() const { return prefabRootOf(workspace.document); }
};

TEST_F(PrefabVisits, openingAndSavingChangesNoByte) {
    for (const auto& [path, text] :
         {std::pair{kTorch, kTorchText}, {kLantern, kLanternText}, {kBig, kBigText}}) {
        ASSERT_TRUE(editPrefab(workspace, path).ok()) << path;
        EXPECT_FALSE(workspace.unsaved());
        EXPECT_EQ(workspace.text(), text) << path;
        workspace.undo.markUnsaved();
        ASSERT_TRUE(workspace.save().ok());
        EXPECT_EQ(fileText(path), text) << path;
        ASSERT_TRUE(workspace.open(kScene).ok());
    }
    ProjectCopy project;
    for (const std::string& path : project.workspace().prefabFiles()) {
        ASSERT_TRUE(editPrefab(project.workspace(), path).ok()) << path;
        EXPECT_EQ(project.workspace().text(), project.fileText()) << path;
    }
}

TEST_F(PrefabVisits, savingAPrefabUpdatesAllInstancesAndKeepsTheirOverrides) {
    workspace.document.selection.set({named("torch")});
    ASSERT_TRUE(runAction(workspace, "edit.duplicate"));
    const ObjectId own = workspace.document.selection.all().front();
    setHeight(own, 99);
    ASSERT_TRUE(workspace.save().ok());
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    setHeight(root(), 40);
    EXPECT_TRUE(workspace.unsaved());
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_NE(fileText(kTorch).find("\"height\": 40"), std::string::npos);
    ASSERT_TRUE(leavePrefab(workspace).ok());
    EXPECT_EQ(workspace.document.scenePath, kScene);
    EXPECT_EQ(heightOf("torch"), 40);
    EXPECT_EQ(world().get<Sprite>(workspace.document.find(own)).height, 99) << "its own";
    int nested = 0;
    world().each<const Sprite, const PrefabPart>([&](const Sprite& sprite, const PrefabPart&) {
        if (sprite.height == 40) ++nested;
    });
    EXPECT_EQ(nested, 1) << "the one inside the lantern";
}

TEST_F(PrefabVisits, returningRestoresTheViewAndTheSelection) {
    workspace.view.show({123.0f, 45.0f}, 3.0f);
    workspace.document.selection.set({named("crate"), named("torch")});
    ASSERT_TRUE(runAction(workspace, "entity.editPrefab"));
    const auto visit = takePrefabVisit(workspace);
    ASSERT_TRUE(visit);
    EXPECT_FALSE(takePrefabVisit(workspace)) << "asked for once";
    go(workspace, *visit);
    EXPECT_TRUE(editsPrefab(workspace));
    EXPECT_EQ(workspace.document.selection.all(), std::vector{root()});
    EXPECT_EQ(fileToReturnTo(workspace), kScene);
    ASSERT_TRUE(leavePrefab(workspace).ok());
    EXPECT_EQ(workspace.view.view().center, (Vec2{123.0f, 45.0f}));
    EXPECT_EQ(workspace.view.zoom(), 3.0f);
    EXPECT_EQ(workspace.document.selection.all(), (std::vector{named("crate"), named("torch")}));
    EXPECT_FALSE(findAction("entity.leavePrefab")->enabled(workspace)) << "a scene is no prefab";
}

TEST_F(PrefabVisits, nestedPrefabsCanBeOpenedAndLeftOneByOne) {
    ASSERT_TRUE(editPrefab(workspace, kLantern).ok());
    workspace.document.selection.set({named("flame")});
    EXPECT_EQ(selectedPrefab(workspace), kTorch);
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    EXPECT_EQ(fileToReturnTo(workspace), kLantern);
    ASSERT_TRUE(leavePrefab(workspace).ok());
    EXPECT_EQ(workspace.document.scenePath, kLantern);
    EXPECT_EQ(fileToReturnTo(workspace), kScene);
    ASSERT_TRUE(workspace.open(kScene).ok());
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    ASSERT_TRUE(workspace.open(kLantern).ok()) << "as from the list of backups";
    EXPECT_EQ(fileToReturnTo(workspace), kScene) << "the first scene, where no way is known";
}

TEST_F(PrefabVisits, newAndMovedEntitiesStayBelowTheRootEntity) {
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    workspace.document.world.get<Transform>(entity("torch")).position = {30.0f, 0.0f};
    ASSERT_TRUE(runAction(workspace, "entity.create"));
    const ObjectId made = workspace.document.selection.all().front();
    EXPECT_EQ(parentOf(world(), workspace.document.find(made)), entity("torch"));
    ASSERT_TRUE(moveInTree(workspace.document, workspace.undo, {named("glow")}, {}));
    EXPECT_EQ(parentOf(world(), entity("glow")), entity("torch"));
    workspace.document.selection.set({root()});
    const std::size_t steps = workspace.undo.size();
    runAction(workspace, "edit.delete");
    EXPECT_EQ(workspace.undo.size(), steps) << "it is the prefab";
    EXPECT_NE(workspace.notice.find("it stays"), std::string::npos);
    ASSERT_TRUE(runAction(workspace, "edit.copy"));
    ASSERT_TRUE(runAction(workspace, "edit.paste"));
    EXPECT_EQ(parentOf(world(), workspace.document.find(workspace.document.selection.all().front())),
              entity("torch"));
    ASSERT_TRUE(workspace.save().ok());
    PrefabLibrary library{workspace.document.types(), workspace.project.root};
    const Result<const Prefab*> read = library.find(kTorch);
    ASSERT_TRUE(read.ok());
    EXPECT_TRUE((*read)->problems.empty());
    EXPECT_EQ((*read)->entities.size(), 8u) << "torch, flame, glow, the new one, and a copy of each";
    EXPECT_EQ(fileText(kTorch).find("[30, 0]"), std::string::npos)
        << "where the first one stands is no part of it";
}

TEST_F(PrefabVisits, newParticlesAndDroppedFilesBecomeChildrenOfTheRootEntity) {
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    const std::string before = workspace.text();
    ASSERT_TRUE(runAction(workspace, "entity.particles"));
    EXPECT_EQ(parentOf(world(), entity("particles")), entity("torch"));
    putFile("assets/spark.wav", "no sound, but a file");
    ASSERT_TRUE(placeAsset(workspace, "assets/spark.wav", {50.0f, 20.0f}).ok());
    const EntityId dropped = workspace.document.find(workspace.document.selection.all().front());
    EXPECT_EQ(parentOf(world(), dropped), entity("torch"));
    const std::string after = workspace.text();
    workspace.undo.jumpTo(0);
    EXPECT_EQ(workspace.text(), before);
    workspace.undo.jumpTo(workspace.undo.total());
    EXPECT_EQ(workspace.text(), after);
}

TEST_F(PrefabVisits, parentsAreWrittenBeforeTheirChildrenAlsoIfTheyArePartsOfANestedPrefab) {
    ASSERT_TRUE(editPrefab(workspace, kLantern).ok());
    ASSERT_TRUE(runAction(workspace, "entity.create"));
    const ObjectId made = workspace.document.selection.all().front();
    // First the new entity is moved before the torch in the file, then it becomes a child of a part of the
    // torch.
    ASSERT_TRUE(stepInTree(workspace.document, workspace.undo, made, -1));
    ASSERT_TRUE(moveInTree(workspace.document, workspace.undo, {made}, {named("flame")}));
    ASSERT_TRUE(workspace.save().ok());
    PrefabLibrary library{workspace.document.types(), workspace.project.root};
    EXPECT_TRUE((*library.find(kLantern))->problems.empty());
    EXPECT_EQ((*library.find(kLantern))->entities.size(), 5u);
}

TEST_F(PrefabVisits, aPrefabCannotContainItself) {
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    for (const std::string& path : {kTorch, kLantern, kBig}) {
        EXPECT_FALSE(addInstance(workspace.prefabs(), path, {}).ok()) << path;
    }
    ASSERT_TRUE(workspace.open(kScene).ok());
    workspace.document.selection.set({named("lantern")});
    ASSERT_TRUE(runAction(workspace, "edit.copy"));
    const std::string copied = workspace.clipboard;
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    workspace.clipboard = copied;
    ASSERT_TRUE(runAction(workspace, "edit.paste"));
    EXPECT_EQ(workspace.undo.size(), 0u);
    EXPECT_NE(workspace.notice.find("cannot be pasted here"), std::string::npos) << workspace.notice;
    EXPECT_FALSE(makePrefab(workspace, {root()}, prefabPath("again")).ok());
}

TEST_F(PrefabVisits, anUnreadablePrefabDoesNotReplaceTheOpenScene) {
    putFile("prefabs/broken.prefab.json", "{}");
    EXPECT_FALSE(editPrefab(workspace, "prefabs/broken.prefab.json").ok());
    EXPECT_EQ(workspace.document.scenePath, kScene);
    EXPECT_FALSE(workspace.notice.empty());
}

TEST_F(PrefabVisits, aPrefabHasAnUndoHistoryOfItsOwnThatIsExact) {
    ASSERT_TRUE(editPrefab(workspace, kBig).ok());
    EXPECT_EQ(workspace.undo.total(), 0u);
    setHeight(root(), 7);
    ASSERT_TRUE(runAction(workspace, "entity.create"));
    ASSERT_TRUE(workspace.undo.undo());
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(workspace.text(), kBigText);
}

TEST_F(PrefabVisits, unsavedPrefabsSurviveACrashAndGetBackupsLikeScenes) {
    workspace.safety.begin();
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    setHeight(root(), 40);
    workspace.update(1.5);
    workspace.safety.finish();
    const std::string journal = fileText(".plumb/session1/prefabs+torch.prefab.json.journal");
    EXPECT_NE(journal.find("\"height\": 40"), std::string::npos);
    EXPECT_EQ(journal.find("prefabFile"), std::string::npos) << "it is the text of the file";
    EXPECT_NE(journal.find("0000000000000077"), std::string::npos);
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_EQ(workspace.safety.backups.of(kTorch).size(), 1u);
    ASSERT_TRUE(workspace.safety.restore(workspace.safety.backups.of(kTorch).front()).ok());
    EXPECT_EQ(workspace.text(), kTorchText);
    EXPECT_TRUE(workspace.unsaved());
    const Result<Path> beside = saveBeside(workspace);
    ASSERT_TRUE(beside.ok());
    EXPECT_EQ(beside->filename(), "torch.mine.prefab.json");
}

TEST_F(PrefabVisits, anOpenPrefabIsReloadedIfAnotherProgramChangesIt) {
    HotReload reload{workspace};
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    reload.poll(0.0);
    std::string text{kTorchText};
    putFile(kTorch, text.replace(text.find("16"), 2, "24"));
    std::filesystem::last_write_time(workspace.project.root / kTorch,
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
    for (int i = 1; i < 10 && heightOf("torch") != 24; ++i) reload.poll(i);
    EXPECT_EQ(heightOf("torch"), 24);
    EXPECT_EQ(workspace.text(), text);
    EXPECT_EQ(root(), named("torch"));
}

/// Tests of the window: questions, the strip of the open prefab, and playing.
class PrefabVisitWindow : public PrefabVisits {
protected:
    PrefabVisitWindow()
        : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}
    [[nodiscard]] bool shows(std::string_view widget) const {
        return window.widgets().find(widget) != nullptr;
    }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(PrefabVisitWindow, aDoubleClickInTheAssetsOpensItAndTheStripGoesBack) {
    hands.click("Tab/Assets");
    hands.rest(40);
    hands.click("Assets/folder/prefabs");
    hands.rest(2);
    hands.click("Assets/" + kTorch);
    hands.clickAt(hands.middleOf("Assets/" + kTorch));
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, kTorch);
    ASSERT_TRUE(shows("Prefab/Back"));
    EXPECT_EQ(window.widgets().find("Prefab/Back")->value, kScene);
    hands.click("Prefab/Back");
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, kScene);
    EXPECT_FALSE(shows("Prefab/Back"));
}

TEST_F(PrefabVisitWindow, theInspectorOpensItAndUnsavedChangesAreConfirmedInBothDirections) {
    workspace.document.selection.set({named("crate")});
    hands.key(Key::Right);
    workspace.document.selection.set({named("torch")});
    hands.rest(2);
    hands.click("Inspector/prefab/edit");
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, kScene) << "it asks first";
    hands.click("Unsaved/Save");
    hands.rest(2);
    ASSERT_EQ(workspace.document.scenePath, kTorch);
    setHeight(root(), 40);
    hands.key(Key::E, {.shift = true, .control = true});
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, kTorch);
    hands.click("Unsaved/Cancel");
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, kTorch);
    hands.click("Prefab/Back");
    hands.rest(2);
    hands.click("Unsaved/Discard");
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, kScene);
    EXPECT_EQ(heightOf("torch"), 16);
}

TEST_F(PrefabVisitWindow, playingReturnsToTheSceneAndPlaysIt) {
    std::string played;
    workspace.makeSession = [&](const std::string& path, const std::string&) {
        played = path;
        return nullptr;
    };
    ASSERT_TRUE(editPrefab(workspace, kLantern).ok());
    ASSERT_TRUE(editPrefab(workspace, kTorch).ok());
    setHeight(root(), 40);
    hands.key(Key::F5);
    hands.rest(2);
    EXPECT_EQ(played, "") << "it asks first";
    hands.click("Unsaved/Save");
    hands.rest(2);
    EXPECT_EQ(played, kScene);
    EXPECT_EQ(workspace.document.scenePath, kScene);
    EXPECT_EQ(heightOf("torch"), 40);
}

}  // namespace
}  // namespace plumb::editor
