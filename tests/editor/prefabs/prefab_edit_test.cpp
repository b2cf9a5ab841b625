#include "editor/model/prefabs/prefab_edit.hpp"

#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/commands/delete_entities.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/tools/select_tool.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kTorch = "prefabs/torch.prefab.json";
constexpr std::string_view kTorchText = R"({
  "format": 1,
  "entities": [
    {
      "id": "0000000000000001",
      "name": "torch",
      "components": {
        "Transform": {
          "scale": [2, 2]
        },
        "Sprite": {
          "width": 8,
          "height": 16,
          "layer": 3
        },
        "Camera": {
          "follow": "000000000000000a"
        },
        "FromTheFuture": {
          "strength": 3
        }
      }
    },
    {
      "id": "000000000000000a",
      "name": "flame",
      "parent": "0000000000000001",
      "components": {
        "Transform": {
          "position": [0, -8]
        },
        "Sprite": {
          "width": 4,
          "height": 4
        }
      }
    }
  ]
}
)";
/// A prefab that contains an instance of the torch and a frame.
constexpr std::string_view kLantern = "prefabs/lantern.prefab.json";
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
      "prefab": "prefabs/torch.prefab.json"
    }
  ]
}
)";
constexpr std::string_view kStreet = "scenes/street.scene.json";
constexpr std::string_view kStreetText = R"({
  "format": 1,
  "effects": {},
  "layers": [],
  "entities": [
    {
      "id": "00000000000000a1",
      "prefab": "prefabs/torch.prefab.json",
      "components": {
        "Transform": {
          "position": [10, 20]
        }
      }
    },
    {
      "id": "00000000000000a2",
      "prefab": "prefabs/torch.prefab.json",
      "components": {
        "Transform": {
          "position": [50, 20]
        },
        "Sprite": {
          "height": 30
        }
      }
    },
    {
      "id": "00000000000000a3",
      "prefab": "prefabs/lantern.prefab.json"
    }
  ]
}
)";

class Prefabs : public EditorFixture {
protected:
    Prefabs() {
        putFile(kTorch, kTorchText);
        putFile(kLantern, kLanternText);
        putFile(kStreet, kStreetText);
        EXPECT_TRUE(workspace.open(kStreet).ok());
        EXPECT_EQ(workspace.document.objectCount(), 7u);
    }

    static constexpr ObjectId kFirst{0xa1};
    static constexpr ObjectId kSecond{0xa2};
    static ObjectId flameOf(ObjectId torch) { return {combinedId(torch.value, 0xa)}; }

    [[nodiscard]] const Sprite& spriteOf(ObjectId id) const {
        return std::as_const(workspace.document.world).get<Sprite>(workspace.document.find(id));
    }
    [[nodiscard]] PrefabOverrides overrides(ObjectId id) {
        const PrefabEdit edit = workspace.prefabs();
        return overridesOf(edit.document, edit.prefabs, id);
    }
    template <class T, class V>
    void set(ObjectId id, std::string_view field, const V& value) {
        const TypeInfo& type = workspace.document.types().of<T>();
        std::vector<SetField::Change> changes;
        changes.push_back({id, FieldValue::of(value)});
        workspace.undo.push(std::make_unique<SetField>(type, *type.find(field), std::move(changes)));
        workspace.undo.endGesture();
    }
    [[nodiscard]] const TypeInfo& sprite() const { return workspace.document.types().of<Sprite>(); }
};

TEST_F(Prefabs, onlyOverridesOfAnInstanceAreMarked) {
    EXPECT_TRUE(overrides(kFirst).isPart);
    EXPECT_EQ(overrides(kFirst).count(), 0u) << "where it stands is its own business";

    const PrefabOverrides second = overrides(kSecond);
    EXPECT_EQ(second.count(), 1u);
    EXPECT_TRUE(second.has(sprite(), "height"));
    EXPECT_FALSE(second.has(sprite(), "width"));

    set<Transform>(flameOf(kFirst), "position", Vec2{1.0f, 1.0f});
    EXPECT_TRUE(overrides(flameOf(kFirst)).has(workspace.document.types().of<Transform>(), "position"));
    EXPECT_FALSE(overrides(named("stranger")).isPart);
}

TEST_F(Prefabs, aClickOnAPartTakesTheWholeInstanceAndAltTakesThePart) {
    const Vec2 onFlame{17.0f, 8.0f};
    SelectTool tool;
    tool.press(workspace.tools(), {.position = onFlame, .reach = 0.0f});
    tool.release(workspace.tools(), {.position = onFlame});
    EXPECT_EQ(workspace.document.selection.all(), std::vector{kFirst});

    tool.press(workspace.tools(), {.position = onFlame, .reach = 0.0f, .modifiers = {.alt = true}});
    tool.release(workspace.tools(), {.position = onFlame});
    EXPECT_EQ(workspace.document.selection.all(), std::vector{flameOf(kFirst)});
}

TEST_F(Prefabs, aBoxSelectsWholeInstancesAndNotTheirParts) {
    SelectTool tool;
    tool.press(workspace.tools(), {.position = {-200.0f, -200.0f}, .reach = 0.0f});
    tool.drag(workspace.tools(), {.position = {17.5f, 8.5f}});
    tool.release(workspace.tools(), {.position = {17.5f, 8.5f}});
    const auto& all = workspace.document.selection.all();
    EXPECT_EQ(std::count(all.begin(), all.end(), kFirst), 1);
    EXPECT_EQ(std::count(all.begin(), all.end(), flameOf(kFirst)), 0);
}

TEST_F(Prefabs, oneFieldIsRevertedAndUndoRestoresIt) {
    set<Sprite>(kSecond, "width", 99);
    const std::string before = workspace.text();

    ASSERT_TRUE(revertToPrefab(workspace.prefabs(), {kFirst, kSecond}, {&sprite(), "height"}));

    EXPECT_EQ(spriteOf(kSecond).height, 16);
    EXPECT_EQ(spriteOf(kSecond).width, 99);
    EXPECT_EQ(workspace.undo.size(), 2u);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
}

TEST_F(Prefabs, removedAndAddedComponentsAreReverted) {
    World& world = workspace.document.world;
    workspace.document.selection.set({kFirst});
    ASSERT_TRUE(revertToPrefab(workspace.prefabs(), {kSecond}, {&sprite()}));
    EXPECT_EQ(spriteOf(kSecond).height, 16);
    EXPECT_FALSE(revertToPrefab(workspace.prefabs(), {kSecond}, {&sprite()})) << "nothing is left to revert";
    EXPECT_EQ(workspace.undo.size(), 1u);

    world.remove<Sprite>(workspace.document.find(kFirst));
    world.add<Label>(workspace.document.find(kFirst));
    EXPECT_TRUE(overrides(kFirst).find(sprite())->removed);
    EXPECT_TRUE(overrides(kFirst).find(workspace.document.types().of<Label>())->added);
    ASSERT_TRUE(revertToPrefab(workspace.prefabs(), {kFirst}, {&sprite()}));
    ASSERT_TRUE(revertToPrefab(workspace.prefabs(), {kFirst}, {&workspace.document.types().of<Label>()}));
    EXPECT_EQ(spriteOf(kFirst).layer, 3);
    EXPECT_FALSE(world.has<Label>(workspace.document.find(kFirst)));
    EXPECT_EQ(overrides(kFirst).count(), 0u);
}

TEST_F(Prefabs, theWholeInstanceIsRevertedWithRemovedPartsButKeepsItsPosition) {
    Document& document = workspace.document;
    set<Transform>(kSecond, "rotation", 0.5f);
    set<Sprite>(flameOf(kSecond), "width", 77);
    workspace.undo.push(std::make_unique<DeleteEntities>(std::vector{flameOf(kSecond)}));
    workspace.undo.endGesture();
    const std::string before = workspace.text();
    document.selection.set({kSecond});

    ASSERT_TRUE(runAction(workspace, "entity.revert"));

    EXPECT_EQ(positionOf(kSecond), (Vec2{50.0f, 20.0f}));
    EXPECT_EQ(document.world.get<Transform>(document.find(kSecond)).rotation, 0.5f);
    EXPECT_EQ(spriteOf(kSecond).height, 16);
    EXPECT_EQ(spriteOf(flameOf(kSecond)).width, 4);
    EXPECT_EQ(parentOf(document.world, document.find(flameOf(kSecond))), document.find(kSecond));
    EXPECT_EQ(document.world.get<Camera>(document.find(kSecond)).follow, document.find(flameOf(kSecond)));
    EXPECT_EQ(document.selection.all(), std::vector{kSecond});
    const std::string after = workspace.text();
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
    workspace.undo.redo();
    EXPECT_EQ(workspace.text(), after);
}

TEST_F(Prefabs, applyingWritesTheFileAndUpdatesInstancesWithoutAnOverride) {
    const ObjectId nested{combinedId(0xa3, 0xbb)};
    set<Sprite>(kFirst, "layer", 7);
    set<Sprite>(kFirst, "height", 24);
    set<Sprite>(flameOf(kFirst), "width", 6);
    const std::string before = workspace.text();
    workspace.document.selection.set({kFirst});

    ASSERT_TRUE(runAction(workspace, "entity.apply"));

    std::string expected{kTorchText};
    expected.replace(expected.find("\"height\": 16"), 12, "\"height\": 24");
    expected.replace(expected.find("\"layer\": 3"), 10, "\"layer\": 7");
    expected.replace(expected.find("\"width\": 4"), 10, "\"width\": 6");
    EXPECT_EQ(fileText(kTorch), expected);
    EXPECT_EQ(overrides(kFirst).count(), 0u);
    EXPECT_EQ(spriteOf(kSecond).layer, 7);
    EXPECT_EQ(spriteOf(kSecond).height, 30) << "its own value stays";
    EXPECT_EQ(spriteOf(flameOf(kSecond)).width, 6);
    EXPECT_EQ(spriteOf(nested).layer, 7) << "also inside other prefabs";
    EXPECT_EQ(positionOf(kSecond), (Vec2{50.0f, 20.0f}));

    const std::string after = workspace.text();
    workspace.undo.undo();
    EXPECT_EQ(fileText(kTorch), kTorchText);
    EXPECT_EQ(workspace.text(), before);
    workspace.undo.redo();
    EXPECT_EQ(fileText(kTorch), expected);
    EXPECT_EQ(workspace.text(), after);
}

TEST_F(Prefabs, applyingOneFieldLeavesTheOthersWithTheInstance) {
    set<Sprite>(kSecond, "layer", 9);

    ASSERT_TRUE(applyToPrefab(workspace.prefabs(), kSecond, {&sprite(), "layer"}).ok());

    EXPECT_EQ(spriteOf(kFirst).layer, 9);
    EXPECT_EQ(spriteOf(kFirst).height, 16);
    EXPECT_TRUE(overrides(kSecond).has(sprite(), "height"));
}

TEST_F(Prefabs, addedAndRemovedComponentsAreApplied) {
    World& world = workspace.document.world;
    world.remove<Camera>(workspace.document.find(kFirst));
    world.add<Label>(workspace.document.find(kFirst)).size = 20.0f;

    ASSERT_TRUE(applyToPrefab(workspace.prefabs(), kFirst).ok());

    EXPECT_EQ(fileText(kTorch).find("Camera"), std::string::npos);
    EXPECT_NE(fileText(kTorch).find("\"Label\": {"), std::string::npos);
    EXPECT_FALSE(world.has<Camera>(workspace.document.find(kSecond)));
    EXPECT_EQ(world.get<Label>(workspace.document.find(kSecond)).size, 20.0f);
    workspace.undo.undo();
    EXPECT_TRUE(world.has<Camera>(workspace.document.find(kSecond)));
    EXPECT_FALSE(world.has<Label>(workspace.document.find(kSecond)));
    EXPECT_EQ(fileText(kTorch), kTorchText);
}

TEST_F(Prefabs, overridesOfNestedPartsAreAppliedToTheOuterPrefab) {
    const ObjectId nested{combinedId(0xa3, 0xbb)};
    set<Sprite>(nested, "layer", 5);
    set<Sprite>({combinedId(0xa3, combinedId(0xbb, 0xa))}, "width", 12);

    ASSERT_TRUE(applyToPrefab(workspace.prefabs(), nested).ok());

    EXPECT_EQ(fileText(kTorch), kTorchText);
    EXPECT_EQ(overrides(nested).count(), 0u);
    ASSERT_TRUE(workspace.save().ok());
    ASSERT_TRUE(workspace.open(kStreet).ok());
    EXPECT_EQ(spriteOf(nested).layer, 5);
    EXPECT_EQ(spriteOf({combinedId(0xa3, combinedId(0xbb, 0xa))}).width, 12);
    EXPECT_EQ(spriteOf(kFirst).layer, 3);
}

TEST_F(Prefabs, referencesToEntitiesOutsideAnInstanceCannotBeApplied) {
    set<Camera>(kFirst, "follow", kSecond);
    const Result<Done> applied = applyToPrefab(workspace.prefabs(), kFirst);
    EXPECT_FALSE(applied.ok());
    EXPECT_EQ(fileText(kTorch), kTorchText);
    EXPECT_EQ(workspace.undo.size(), 1u);

    set<Camera>(kFirst, "follow", kFirst);
    ASSERT_TRUE(applyToPrefab(workspace.prefabs(), kFirst).ok());
    const Document& document = workspace.document;
    EXPECT_EQ(document.world.get<Camera>(document.find(kSecond)).follow, document.find(kSecond));
}

TEST_F(Prefabs, aDuplicateKeepsItsPartsWhenItIsSavedAndOpened) {
    workspace.document.selection.set({kSecond});
    ASSERT_TRUE(runAction(workspace, "edit.duplicate"));
    const ObjectId copy = workspace.document.selection.all().front();
    set<Sprite>(flameOf(copy), "width", 11);
    ASSERT_TRUE(workspace.save().ok());
    ASSERT_TRUE(workspace.open(kStreet).ok());

    EXPECT_EQ(workspace.document.objectCount(), 9u);
    EXPECT_EQ(spriteOf(copy).height, 30);
    EXPECT_EQ(spriteOf(flameOf(copy)).width, 11);
    EXPECT_EQ(spriteOf(flameOf(kSecond)).width, 4);
}

TEST_F(Prefabs, addingAnInstanceFromItsFileCanBeUndone) {
    const std::string before = workspace.text();
    ASSERT_TRUE(addInstance(workspace.prefabs(), kTorch, {5.0f, 6.0f}).ok());

    const ObjectId added = workspace.document.selection.all().front();
    EXPECT_EQ(positionOf(added), (Vec2{5.0f, 6.0f}));
    EXPECT_EQ(spriteOf(added).height, 16);
    EXPECT_EQ(spriteOf(flameOf(added)).width, 4);
    EXPECT_EQ(overrides(added).count(), 0u);
    EXPECT_EQ(workspace.document.objectCount(), 9u);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
    EXPECT_FALSE(addInstance(workspace.prefabs(), "prefabs/none.prefab.json", {}).ok());
}

}  // namespace
}  // namespace plumb::editor
