// Notices and dialogs that explain why an action was not performed or had an unexpected result.

#include <array>

#include "app/project.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/assets/place_asset.hpp"
#include "editor/model/finder/finder.hpp"
#include "editor/model/play/game_session.hpp"
#include "editor/model/play/play_mode.hpp"
#include "editor/model/play/scene_of_game.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "editor/model/problems.hpp"
#include "editor/model/safety/scene_differences.hpp"
#include "scene/scene_requests.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/editor/support/tile_scene.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

class MissedStrokes : public TileScene {
protected:
    [[nodiscard]] std::string at(int x, int y) const {
        return std::string{whyNotPainted(workspace, middleOf(x, y))};
    }
};

TEST_F(MissedStrokes, besideTheLayerOrOnALockedOrHiddenLayer) {
    EXPECT_EQ(at(9, 9), "") << "no tile tool is in the hand";
    runAction(workspace, "tool.brush");
    EXPECT_EQ(at(2, 2), "");
    EXPECT_NE(at(8, 2).find("outside the layer"), std::string::npos);
    EXPECT_NE(at(-1, 0).find("outside the layer"), std::string::npos);
    workspace.document.view.setLocked(layer(), true);
    EXPECT_NE(at(2, 2).find("locked"), std::string::npos);
    workspace.document.view.setLocked(layer(), false);
    workspace.document.view.setHidden(layer(), true);
    EXPECT_NE(at(2, 2).find("hidden"), std::string::npos);
}

class Said : public EditorFixture {
protected:
    Said() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            return makeGameSession(project, path, text);
        };
    }
    [[nodiscard]] bool shows(std::string_view path) const { return window.widgets().find(path) != nullptr; }
    [[nodiscard]] std::string valueOf(std::string_view path) const {
        EXPECT_TRUE(shows(path)) << path;
        return shows(path) ? window.widgets().find(path)->value : std::string{};
    }
    void create() { ASSERT_TRUE(runAction(workspace, "entity.create")); }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(Said, newEntitiesHaveUniqueNames) {
    create(), create(), create();
    EXPECT_TRUE(named("new entity"));
    EXPECT_TRUE(named("new entity 2"));
    EXPECT_TRUE(named("new entity 3"));
    ASSERT_TRUE(runAction(workspace, "entity.camera"));
    EXPECT_TRUE(named("camera 2"));
}

TEST_F(Said, openingAnotherSceneClearsTheUndoHistory) {
    putFile("scenes/cave.scene.json", kSceneText);
    create();
    ASSERT_TRUE(workspace.save().ok());
    ASSERT_TRUE(workspace.open("scenes/cave.scene.json").ok());
    EXPECT_NE(workspace.notice.find("the undo history of scenes/level.scene.json was cleared"),
              std::string::npos);
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_EQ(workspace.notice.find("undo"), std::string::npos) << "there were none";
}

TEST_F(Said, errorsOfASceneAreShownInTheViewport) {
    putFile("scenes/broken.scene.json", "{\n  \"format\": 1,\n  \"entities\": [}\n}");
    EXPECT_FALSE(workspace.open("scenes/broken.scene.json").ok());
    EXPECT_NE(problemsOf(workspace).load.find("3"), std::string::npos)
        << "the line: " << problemsOf(workspace).load;
    hands.rest(3);
    EXPECT_TRUE(shows("Viewport/empty"));
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_EQ(problemsOf(workspace).load, "");
}

TEST_F(Said, aSaveThatFailsIsAQuestionOfItsOwn) {
    create();
    const Path scenes = workspace.project.root / "scenes";
    std::filesystem::rename(scenes, workspace.project.root / "away");
    putFile("scenes", "a file is in the way");
    hands.key(Key::S, {.control = true});
    hands.rest(3);
    ASSERT_TRUE(shows("NotSaved/again"));
    EXPECT_NE(valueOf("NotSaved/problem"), "");
    hands.click("NotSaved/again");
    hands.rest(3);
    ASSERT_TRUE(shows("NotSaved/again")) << "it fails again";
    std::filesystem::remove(scenes);
    std::filesystem::rename(workspace.project.root / "away", scenes);
    hands.click("NotSaved/again");
    hands.rest(3);
    EXPECT_FALSE(shows("NotSaved/again"));
    EXPECT_EQ(fileText(), workspace.text());
}

TEST_F(Said, theSceneIsSavedWhileAGamePlays) {
    create();
    hands.key(Key::F5);
    hands.rest(5);
    ASSERT_TRUE(workspace.play.running());
    hands.key(Key::S, {.control = true});
    hands.rest(2);
    EXPECT_FALSE(workspace.unsaved());
    EXPECT_EQ(fileText(), workspace.text());
    EXPECT_NE(valueOf("Status/notice").find("Saved"), std::string::npos) << valueOf("Status/notice");
}

TEST_F(Said, anotherEditorOfTheProject) {
    workspace.safety.begin();
    EXPECT_EQ(workspace.notice.find("Another editor"), std::string::npos);
    Workspace other{workspace.document.types(), workspace.assets, {workspace.project.root}};
    ASSERT_TRUE(other.open(kScene).ok());
    other.safety.begin();
    EXPECT_NE(other.notice.find("Another editor"), std::string::npos);
}

TEST_F(Said, aUsedSceneNameIsReportedBeforeAnyQuestion) {
    create();
    workspace.request = WindowRequest::NameNewScene;
    hands.rest(3);
    hands.type("level");
    hands.click("New/Create");
    hands.rest(3);
    EXPECT_FALSE(shows("Unsaved/Save"));
    EXPECT_NE(valueOf("New/problem").find("a scene with this name exists"), std::string::npos);
    hands.click("New/name");
    hands.type("2");
    hands.click("New/Create");
    hands.rest(3);
    EXPECT_TRUE(shows("Unsaved/Save"));
}

TEST_F(Said, whatAGameChangedIsOfferedAgainWhenAnotherQuestionWasBetween) {
    create();
    hands.key(Key::F5);
    hands.rest(5);
    const TypeInfo& type = workspace.document.types().of<Transform>();
    workspace.play.edit(named("crate"), type, *type.find("position"), FieldValue::of(Vec2{7.0f, 8.0f}));
    hands.key(Key::F5);
    hands.rest(3);
    ASSERT_TRUE(shows("Keep/keep"));
    const std::array close{Event{.kind = EventKind::Quit}};
    window.frame({close});
    hands.rest(3);
    ASSERT_TRUE(shows("Unsaved/Cancel"));
    hands.click("Unsaved/Cancel");
    hands.rest(3);
    ASSERT_TRUE(shows("Keep/keep"));
    hands.key(Key::Escape);
    hands.rest(3);
    EXPECT_FALSE(shows("Keep/keep"));
    EXPECT_EQ(workspace.notice, "Nothing was kept");
}

TEST_F(Said, theSceneOfAGameThatChangedScenes) {
    putFile("scenes/cave.scene.json", kSceneText);
    EXPECT_EQ(sceneOfGame(workspace), "");
    hands.key(Key::F5);
    hands.rest(5);
    EXPECT_EQ(sceneOfGame(workspace), kScene);
    EXPECT_FALSE(shows("Scene/game"));
    World& world = workspace.play.world();
    world.resource<SceneRequests>().next = world.texts().add("scenes/cave.scene.json");
    hands.rest(10);
    EXPECT_EQ(valueOf("Scene/game"), "scenes/cave.scene.json");
    EXPECT_NE(valueOf("Menu/title").find("cave"), std::string::npos);
}

TEST_F(Said, aGameWithoutACamera) {
    hands.key(Key::F5);
    hands.rest(5);
    EXPECT_FALSE(shows("Viewport/no camera"));
    hands.key(Key::F5);
    workspace.document.selection.set({named("camera")});
    ASSERT_TRUE(runAction(workspace, "edit.delete"));
    hands.key(Key::F5);
    hands.rest(5);
    EXPECT_TRUE(shows("Viewport/no camera"));
}

TEST_F(Said, heldKeysCountWhenAPausedGameResumesButEarlierTapsDoNot) {
    hands.key(Key::F5);
    hands.rest(5);
    hands.key(Key::F6);
    ASSERT_TRUE(workspace.play.paused());
    const auto key = [&](EventKind kind, Key which) {
        const std::array events{Event{.kind = kind, .key = which}};
        window.frame({events});
    };
    key(EventKind::KeyDown, Key::Up), key(EventKind::KeyUp, Key::Up);
    hands.rest(2);
    key(EventKind::KeyDown, Key::Right);
    hands.rest(2);
    InputFrame input = workspace.gameInput();
    EXPECT_TRUE(input.has(Key::Right));
    EXPECT_FALSE(input.has(Key::Up));
    hands.key(Key::F6);
    ASSERT_FALSE(workspace.play.paused());
    EXPECT_TRUE(workspace.gameInput().has(Key::Right));
    hands.key(Key::F6);
    key(EventKind::KeyUp, Key::Right);
    EXPECT_FALSE(workspace.gameInput().has(Key::Right)) << "let go while it was paused";
}

TEST_F(Said, aTypedNumberOfCellsIsAppliedByTab) {
    workspace.document.selection.set({named("ground")});
    hands.rest(3);
    const auto width = [&] {
        const World& world = workspace.document.world;
        return world.tiles()
            .find(world.get<TileLayer>(workspace.document.find(named("ground"))).cells)
            ->width();
    };
    ASSERT_EQ(width(), 4);
    const auto type = [&](std::string_view digits, Key leave) {
        hands.click("Inspector/TileLayer/cells.width");
        hands.rest(2);
        hands.key(Key::A, {.control = true});
        hands.type(digits);
        hands.key(leave);
        hands.rest(3);
    };
    type("7", Key::Escape);
    EXPECT_EQ(width(), 4);
    type("9", Key::Tab);
    EXPECT_EQ(width(), 9);
    type("5", Key::Enter);
    EXPECT_EQ(width(), 5);
}

TEST_F(Said, valuesEqualToThePrefabAreNotMarkedWhileTheGamePlays) {
    const Result<ObjectId> crate = makePrefab(workspace, {named("crate")}, prefabPath("crate"));
    ASSERT_TRUE(crate.ok());
    workspace.document.selection.set({*crate});
    hands.rest(3);
    const std::string before = valueOf("Inspector/BoxCollider/width/label");
    hands.key(Key::F5);
    hands.rest(5);
    EXPECT_EQ(valueOf("Inspector/BoxCollider/width/label"), before);
    EXPECT_EQ(before, "");
}

TEST_F(Said, aSceneIsOpenedByAFewLettersAndEnter) {
    putFile("scenes/cave.scene.json", kSceneText);
    putFile("scenes/attic.scene.json", kSceneText);
    hands.key(Key::O, {.control = true});
    hands.rest(3);
    EXPECT_TRUE(shows("Finder/level.scene.json"));
    hands.type("cav");
    hands.rest(2);
    EXPECT_FALSE(shows("Finder/level.scene.json"));
    hands.key(Key::Enter);
    hands.rest(3);
    EXPECT_EQ(workspace.document.scenePath, "scenes/cave.scene.json");
    hands.key(Key::O, {.control = true});
    hands.rest(3);
    hands.key(Key::Down);
    hands.key(Key::Escape);
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, "scenes/cave.scene.json");
}

TEST(ScenesFound, instancesAreNamedAfterTheirPrefab) {
    const auto scene = [](const char* at) {
        return format(R"({"entities": [{"id": "00000000000000a7", "prefab": "prefabs/coin.prefab.json",
            "components": {"Transform": {"position": [{}, 0]}}}]})",
                      at);
    };
    EXPECT_EQ(sceneDifferences(scene("1"), scene("2")).front(),
              "coin (00a7): Transform.position was [1,0], is [2,0]");
}

TEST(PlacedOnGrid, spritesWithABottomPivotArePlacedOnTheLowerEdgeOfTheCell) {
    const Vec2 step{16.0f, 16.0f};
    const PlacedPicture standing{{}, {0.5f, 1.0f}};
    EXPECT_EQ(placedOnGrid({50.0f, 130.0f}, standing, step), (Vec2{48.0f, 144.0f})) << "high in the cell";
    EXPECT_EQ(placedOnGrid({50.0f, 143.0f}, standing, step), (Vec2{48.0f, 144.0f})) << "low in it";
    EXPECT_EQ(placedOnGrid({50.0f, 144.0f}, standing, step), (Vec2{48.0f, 144.0f})) << "on the line";
    EXPECT_EQ(placedOnGrid({50.0f, 130.0f}, PlacedPicture{}, step), (Vec2{48.0f, 128.0f})) << "in its middle";
}

TEST(PlacedOnGrid, spritesOfWholeCellsAreAlignedToCellsForAnyPivot) {
    const Vec2 step{16.0f, 16.0f}, standing{0.5f, 1.0f};
    for (const Vec2 pivot : {Vec2{0.5f, 0.5f}, Vec2{0.5f, 1.0f}, Vec2{0.25f, 0.75f}, Vec2{1.0f, 1.0f}}) {
        for (const Vec2 size : {Vec2{16.0f, 16.0f}, Vec2{48.0f, 32.0f}, Vec2{160.0f, 16.0f}}) {
            const Vec2 mouse{203.0f, 77.0f};
            const Vec2 corner = placedOnGrid(mouse, {size, pivot}, step) - scaled(size, pivot);
            EXPECT_EQ(corner, snapped(corner, step));
            // The pivot is in the cell under the mouse or on its border.
            const Vec2 offset = corner + scaled(size, pivot) - mouse;
            EXPECT_LE(std::max(std::abs(offset.x), std::abs(offset.y)), 16.0f);
        }
    }
    EXPECT_EQ(placedOnGrid({50.0f, 130.0f}, {{16.0f, 32.0f}, standing}, step), (Vec2{56.0f, 144.0f}));
    EXPECT_EQ(placedOnGrid({50.0f, 144.0f}, {{16.0f, 32.0f}, standing}, step), (Vec2{56.0f, 144.0f}));
    EXPECT_EQ(placedOnGrid({50.0f, 130.0f}, {{20.0f, 30.0f}}, step), (Vec2{48.0f, 128.0f})) << "of no cells";
}

}  // namespace
}  // namespace plumb::editor::ui
