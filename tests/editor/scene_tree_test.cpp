// Tests of the scene tree: filter, order, parents and children, multiple selection, visibility and locks.

#include "editor/model/document/scene_tree.hpp"

#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/commands/reorder.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/document/visibility.hpp"
#include "editor/model/tree_edit.hpp"
#include "scene/world_transform.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

using ui::EditorWindow;
using ui::Hands;

class SceneTreeTest : public EditorFixture {
protected:
    [[nodiscard]] std::vector<std::string> rows(std::string_view filter = "") {
        tree.follow(workspace.document, filter);
        std::vector<std::string> names;
        for (const SceneTree::Row& row : tree.rows()) {
            names.push_back(std::string(static_cast<std::size_t>(row.depth), ' ') +
                            workspace.document.nameOf(row.id));
        }
        return names;
    }
    [[nodiscard]] std::string parentOfNamed(std::string_view name) const {
        const Document& document = workspace.document;
        const EntityId parent = parentOf(document.world, document.find(named(name)));
        return parent ? document.nameOf(document.idOf(parent)) : "";
    }

    SceneTree tree;
};

using Names = std::vector<std::string>;

TEST_F(SceneTreeTest, childrenAreListedBelowTheirParentsInFileOrder) {
    EXPECT_EQ(rows(), (Names{"camera", "player", " lamp", "crate", "sign", "ground"}));
    tree.setClosed(named("player"), true);
    EXPECT_EQ(rows(), (Names{"camera", "player", "crate", "sign", "ground"}));
    tree.openTo(workspace.document, named("lamp"));
    EXPECT_EQ(rows().size(), 6u);
}

TEST_F(SceneTreeTest, wordsMatchNamesAndComponentsAndThePrefixCOnlyComponents) {
    EXPECT_EQ(rows("cra"), (Names{"crate"}));
    EXPECT_EQ(rows("boxcollider"), (Names{"player", "crate"}));
    EXPECT_EQ(rows("box cra"), (Names{"crate"})) << "all words";
    EXPECT_EQ(rows("camera"), (Names{"camera"}));
    EXPECT_EQ(rows("c:RigidBody"), (Names{"player"}));
    EXPECT_EQ(rows("c:crate"), (Names{})) << "no component is called so";
    EXPECT_EQ(rows("c:"), rows("")) << "nothing is looked for yet";
}

TEST_F(SceneTreeTest, followsEveryKindOfChange) {
    static_cast<void>(rows());
    const auto changes = [&](const char* action, Names wanted) {
        EXPECT_TRUE(runAction(workspace, action)) << action;
        EXPECT_EQ(rows(), wanted) << action;
    };
    workspace.document.selection.set({named("sign")});
    changes("entity.earlier", {"camera", "player", " lamp", "sign", "crate", "ground"});
    changes("edit.delete", {"camera", "player", " lamp", "crate", "ground"});
    changes("edit.undo", {"camera", "player", " lamp", "sign", "crate", "ground"});
    workspace.document.selection.set({named("crate"), named("sign")});
    changes("entity.group", {"camera", "player", " lamp", "group", " sign", " crate", "ground"});
    changes("edit.undo", {"camera", "player", " lamp", "sign", "crate", "ground"});
}

TEST_F(SceneTreeTest, aMoveNextToASiblingIsOneStepAndUndoneByteForByte) {
    Document& document = workspace.document;
    ASSERT_TRUE(moveInTree(document, workspace.undo, {named("sign")}, {{}, named("camera"), true}));
    EXPECT_EQ(rows(), (Names{"camera", "sign", "player", " lamp", "crate", "ground"}));
    ASSERT_TRUE(moveInTree(document, workspace.undo, {named("ground"), named("crate")},
                           {named("player"), named("lamp"), false}));
    EXPECT_EQ(rows(), (Names{"camera", "sign", "player", " crate", " ground", " lamp"}))
        << "in the order of the file, whatever was selected first";
    EXPECT_EQ(workspace.undo.size(), 2u);
    const std::string changed = workspace.text();
    ASSERT_TRUE(workspace.save().ok());
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_EQ(workspace.text(), changed);
    EXPECT_EQ(rows(), (Names{"camera", "sign", "player", " crate", " ground", " lamp"})) << "as saved";
}

TEST_F(SceneTreeTest, movesWithoutEffectLeaveNoUndoStep) {
    EXPECT_FALSE(
        moveInTree(workspace.document, workspace.undo, {named("crate")}, {{}, named("sign"), false}));
    EXPECT_FALSE(moveInTree(workspace.document, workspace.undo, {named("player")}, {named("lamp")}))
        << "nothing becomes a child of itself";
    EXPECT_EQ(workspace.undo.size(), 0u);
    EXPECT_EQ(workspace.text(), kSceneText);
}

/// For random moves: entities keep their world position, none is lost, and undo restores the bytes.
TEST_F(SceneTreeTest, anyMovesKeepThePlaceInTheWorldAndAreUndone) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Document& document = workspace.document;
        const auto some = [&] {
            const std::vector<ObjectId>& all = document.objects();
            return all[random.below(static_cast<std::uint32_t>(all.size()))];
        };
        for (int i = 0; i < 12; ++i) {
            std::vector<Pose> before;
            const std::vector<ObjectId> all = document.objects();
            for (const ObjectId id : all) before.push_back(worldPose(document.world, document.find(id)));
            if (random.below(5) == 0) {
                groupEntities(document, workspace.undo, {some(), some()});
            } else {
                const ObjectId beside = some();
                const ObjectId parent =
                    document.idOf(parentOf(std::as_const(document.world), document.find(beside)));
                const bool into = random.below(3) == 0;
                moveInTree(document, workspace.undo, {some(), some()},
                           into ? TreePlace{beside} : TreePlace{parent, beside, random.below(2) == 0});
            }
            for (std::size_t k = 0; k < all.size(); ++k) {
                const Pose now = worldPose(document.world, document.find(all[k]));
                EXPECT_NEAR(distance(now.position, before[k].position), 0.0f, 1e-3f);
                EXPECT_NEAR(now.rotation, before[k].rotation, 1e-4f);
            }
            EXPECT_EQ(rows().size(), document.objectCount()) << "all are in the tree, each once";
        }
        const std::string after = workspace.text();
        const std::size_t steps = workspace.undo.size();
        workspace.undo.jumpTo(0);
        EXPECT_EQ(workspace.text(), kSceneText);
        workspace.undo.jumpTo(steps);
        EXPECT_EQ(workspace.text(), after);
        workspace.undo.jumpTo(0);
    }
}

TEST_F(SceneTreeTest, unreadableEntitiesKeepTheirPositionInTheFile) {
    constexpr std::string_view kScenePath = "scenes/kept.scene.json";
    putFile(kScenePath, R"({"format": 1, "entities": [
      {"id": "0000000000000001", "name": "a", "components": {"Transform": {}}},
      {"id": 7, "name": "broken"},
      {"id": "0000000000000003", "name": "b", "components": {"Transform": {}}},
      {"id": "0000000000000004", "name": "c", "components": {"Transform": {}}}]})");
    ASSERT_TRUE(workspace.open(kScenePath).ok());
    const std::string before = workspace.text();
    ASSERT_TRUE(moveInTree(workspace.document, workspace.undo, {named("c")}, {{}, named("a"), false}));
    const std::string after = workspace.text();
    EXPECT_LT(after.find("\"c\""), after.find("\"a\""));
    EXPECT_LT(after.find("\"a\""), after.find("\"b\""));
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(workspace.text(), before);
}

TEST_F(SceneTreeTest, theMouseGoesThroughWhatIsLockedOrHiddenWithAllBelowIt) {
    const Document& document = workspace.document;
    const Vec2 crate{216.0f, 80.0f};
    ASSERT_EQ(pickFirst(document, crate, 1.0f), named("crate"));
    workspace.document.view.setLocked(named("crate"), true);
    EXPECT_FALSE(pickFirst(document, crate, 1.0f));
    workspace.document.view.setLocked(named("crate"), false);
    workspace.document.view.setHidden(named("crate"), true);
    EXPECT_FALSE(pickFirst(document, crate, 1.0f));
    EXPECT_EQ(pickInside(document, {{190.0f, 60.0f}, {240.0f, 100.0f}}), std::vector<ObjectId>{});

    workspace.document.view.setLocked(named("player"), true);
    EXPECT_TRUE(isLocked(document, named("lamp"))) << "below it";
    EXPECT_EQ(hiddenEntities(document), std::vector{document.find(named("crate"))});
    ASSERT_TRUE(runAction(workspace, "edit.selectAll"));
    EXPECT_EQ(document.selection.all(), (std::vector{named("camera"), named("sign"), named("ground")}));
    EXPECT_FALSE(workspace.unsaved()) << "a way of looking";
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(SceneTreeTest, whatIsLockedIsNotMovedWithTheOthers) {
    workspace.document.view.setLocked(named("sign"), true);
    workspace.document.selection.set({named("crate"), named("sign")});
    ASSERT_TRUE(runAction(workspace, "entity.right"));
    EXPECT_EQ(positionOf(named("crate")).x, 201.0f);
    EXPECT_EQ(positionOf(named("sign")).x, 100.0f);
}

TEST_F(SceneTreeTest, whatIsHiddenAndLockedIsRememberedBesideTheProject) {
    workspace.document.view.setHidden(named("crate"), true);
    workspace.document.view.setLocked(named("sign"), true);
    workspace.update(0.1);
    const Path file = workspace.project.root / ".plumb/view/scenes/level.scene.json.view";
    EXPECT_TRUE(std::filesystem::exists(file));
    EXPECT_TRUE(std::filesystem::exists(workspace.project.root / ".plumb/.gitignore"));
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_TRUE(workspace.document.view.isHidden(named("crate")));
    EXPECT_TRUE(workspace.document.view.locks(named("sign")));
    ASSERT_TRUE(runAction(workspace, "entity.showAll"));
    workspace.update(0.1);
    EXPECT_FALSE(std::filesystem::exists(file)) << "nothing is left behind";
}

/// Bounding boxes are cached between frames; every write to the world must update them.
TEST_F(SceneTreeTest, pickingFollowsEveryWriteToTheWorld) {
    World& world = workspace.document.world;
    const Document& document = workspace.document;
    ASSERT_EQ(pickFirst(document, {216.0f, 80.0f}, 1.0f), named("crate"));
    world.get<Transform>(document.find(named("crate"))).position = {400.0f, 400.0f};
    EXPECT_FALSE(pickFirst(document, {216.0f, 80.0f}, 1.0f));
    EXPECT_EQ(pickFirst(document, {410.0f, 410.0f}, 1.0f), named("crate"));
    world.get<BoxCollider>(document.find(named("crate"))).width = 200.0f;
    EXPECT_EQ(pickFirst(document, {590.0f, 410.0f}, 1.0f), named("crate"));
    world.remove<BoxCollider>(document.find(named("crate")));
    EXPECT_FALSE(pickFirst(document, {590.0f, 410.0f}, 1.0f));
    world.get<Transform>(document.find(named("player"))).position = {40.0f, 600.0f};
    EXPECT_EQ(pickFirst(document, {50.0f, 590.0f}, 1.0f), named("lamp")) << "below what moved";
    const TilesId cells = world.get<TileLayer>(document.find(named("ground"))).cells;
    TileGrid large{100, 100};
    large.set(62, 62, 1);
    *const_cast<TileGrid*>(world.tiles().find(cells)) = large;
    EXPECT_EQ(pickFirst(document, {1000.0f, 1000.0f}, 1.0f), named("ground"));
}

/// A fade or painted sky in front of everything: a click selects the entity behind it.
TEST_F(SceneTreeTest, aSpriteThatFillsTheImageIsPickedLast) {
    Document& document = workspace.document;
    const EntityId lamp = document.find(named("lamp"));
    document.world.get<Transform>(lamp).position = {-40.0f, -100.0f};  // world position (0, 0)
    auto& fade = document.world.add<Sprite>(lamp);
    fade.layer = 10;
    fade.width = static_cast<int>(document.picture.x);
    fade.height = static_cast<int>(document.picture.y) - 1;
    const Vec2 crate{216.0f, 80.0f};
    EXPECT_EQ(pickFirst(document, crate, 1.0f), named("lamp")) << "one row less than the picture";
    ++fade.height;
    EXPECT_EQ(pickFirst(document, crate, 1.0f), named("crate"));
    EXPECT_EQ(pickFirst(document, {300.0f, 300.0f}, 1.0f), named("lamp")) << "where nothing else is";
    EXPECT_EQ(pickInside(document, {{190.0f, 60.0f}, {240.0f, 100.0f}}), std::vector{named("crate")});
}

// Tests with simulated mouse and keyboard.

class TreeHands : public SceneTreeTest {
protected:
    TreeHands() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {}

    /// Position in a row of the tree; `part` is 0 at its upper edge and 1 at its lower one.
    [[nodiscard]] Vec2 inRow(std::string_view name, float part) const {
        const auto* row = window.widgets().find(std::string{"Scene/"} + std::string{name});
        EXPECT_NE(row, nullptr) << name;
        return {row->box.min.x + 60.0f, lerp(row->box.min.y, row->box.max.y, part)};
    }
    void dragRow(std::string_view from, std::string_view to, float part) {
        hands.drag(inRow(from, 0.5f), inRow(to, part));
    }
    void clickWith(Modifiers held, std::string_view row) {
        hands.held = held;
        hands.clickAt(inRow(row, 0.5f));
        hands.held = {};
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(TreeHands, rowsAreDraggedBeforeBehindAndIntoOthers) {
    dragRow("sign", "camera", 0.05f);
    EXPECT_EQ(rows(), (Names{"sign", "camera", "player", " lamp", "crate", "ground"}));
    dragRow("sign", "crate", 0.95f);
    EXPECT_EQ(rows(), (Names{"camera", "player", " lamp", "crate", "sign", "ground"}));
    dragRow("sign", "player", 0.95f);
    EXPECT_EQ(rows(), (Names{"camera", "player", " sign", " lamp", "crate", "ground"})) << "its first child";
    dragRow("sign", "crate", 0.5f);
    EXPECT_EQ(parentOfNamed("sign"), "crate");
    EXPECT_EQ(workspace.undo.size(), 4u);
    workspace.undo.jumpTo(0);
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(TreeHands, severalAreDraggedTogether) {
    hands.click("Scene/camera");
    clickWith({.control = true}, "sign");
    hands.rest(30);  // so that the clicks are not counted as a double click
    dragRow("sign", "crate", 0.5f);
    EXPECT_EQ(parentOfNamed("sign"), "crate");
    EXPECT_EQ(parentOfNamed("camera"), "crate");
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(TreeHands, shiftSelectsARangeAndControlTogglesARow) {
    const Selection& selection = workspace.document.selection;
    hands.click("Scene/player");
    clickWith({.shift = true}, "sign");
    EXPECT_EQ(selection.all(), (std::vector{named("player"), named("lamp"), named("crate"), named("sign")}));
    clickWith({.shift = true}, "lamp");
    EXPECT_EQ(selection.all(), (std::vector{named("player"), named("lamp")})) << "from the same row";
    clickWith({.control = true}, "ground");
    EXPECT_EQ(selection.all().back(), named("ground"));
    clickWith({.shift = true, .control = true}, "sign");
    EXPECT_EQ(selection.size(), 4u) << "others stay";
    clickWith({.control = true}, "lamp");
    EXPECT_FALSE(selection.has(named("lamp")));
}

TEST_F(TreeHands, theEyeAndTheLockOfARowAreClicked) {
    hands.click("Scene/crate/eye");
    EXPECT_TRUE(workspace.document.view.isHidden(named("crate")));
    EXPECT_TRUE(workspace.document.selection.empty()) << "a click on the eye selects nothing";
    hands.click("Scene/crate/eye");
    EXPECT_TRUE(workspace.document.view.showsAll());
    hands.click("Scene/crate");
    clickWith({.control = true}, "sign");
    hands.click("Scene/sign/lock");
    EXPECT_TRUE(workspace.document.view.locks(named("crate"))) << "all that is selected";
    EXPECT_EQ(window.widgets().find("Scene/crate/lock")->value, "on");
    hands.key(Key::L, {.control = true});
    EXPECT_TRUE(workspace.document.view.showsAll());
    hands.key(Key::H, {.control = true});
    EXPECT_EQ(workspace.document.view.hidden().size(), 2u);
}

TEST_F(TreeHands, theFilterIsTypedAndCleared) {
    hands.click("Scene/filter");
    hands.type("c:rigid");
    hands.rest();
    EXPECT_NE(window.widgets().find("Scene/player"), nullptr);
    EXPECT_EQ(window.widgets().find("Scene/crate"), nullptr);
    hands.click("Scene/filter/clear");
    hands.rest();
    EXPECT_NE(window.widgets().find("Scene/crate"), nullptr);
}

TEST_F(TreeHands, aNameIsChangedInItsRow) {
    hands.click("Scene/crate");
    hands.key(Key::F2);
    hands.rest(2);
    hands.type("box");
    hands.key(Key::Enter);
    EXPECT_TRUE(named("box"));
    EXPECT_EQ(workspace.undo.size(), 1u);
}

}  // namespace
}  // namespace plumb::editor
