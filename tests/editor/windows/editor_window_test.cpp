#include <imgui.h>

#include "assets/tileset.hpp"
#include "core/random.hpp"
#include "editor/model/play/game_session.hpp"
#include "editor/ui/overlays/overlay_list.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

class EditorWindowTest : public EditorFixture {
protected:
    EditorWindowTest()
        : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            return makeGameSession(project, path, text);
        };
    }
    [[nodiscard]] Vec2 onScreen(Vec2 world) const {
        return window.widgets().find("Viewport")->box.min + workspace.view.toScreenPoint(world);
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(EditorWindowTest, aLevelIsOpenedChangedUndoneSavedReopenedAndPlayed) {
    // select an entity in the viewport and drag it with the select tool
    const Vec2 crate{216.0f, 80.0f};
    hands.clickAt(onScreen(crate));
    ASSERT_EQ(workspace.document.selection.all(), std::vector{named("crate")});
    workspace.grid.snap = false;
    const Vec2 grab = onScreen(crate);
    hands.drag(grab, grab + Vec2{40.0f, 0.0f} * workspace.view.zoom());
    EXPECT_EQ(positionOf(named("crate")), (Vec2{240.0f, 64.0f}));
    EXPECT_EQ(workspace.undo.size(), 1u);

    // edit a field in the inspector
    hands.enterNumber("Inspector/Transform/position.y", "48");
    EXPECT_EQ(positionOf(named("crate")), (Vec2{240.0f, 48.0f}));
    EXPECT_EQ(workspace.undo.size(), 2u);
    const std::string changed = workspace.text();

    // undo and redo by shortcuts
    hands.key(Key::Z, {.control = true});
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(workspace.text(), kSceneText);
    hands.key(Key::Y, {.control = true});
    hands.key(Key::Z, {.shift = true, .control = true});
    EXPECT_EQ(workspace.text(), changed);

    // save and reopen the scene
    hands.key(Key::S, {.control = true});
    EXPECT_EQ(fileText(), changed);
    EXPECT_FALSE(workspace.unsaved());
    ASSERT_TRUE(workspace.open(kScene).ok());
    EXPECT_EQ(workspace.text(), changed);

    // play 60 ticks and stop
    hands.key(Key::F5);
    ASSERT_TRUE(workspace.play.running());
    while (workspace.play.ticks() < 60) {
        hands.rest();
    }
    const EntityId player = workspace.play.find(named("player"));
    EXPECT_GT(workspace.play.world().get<Transform>(player).position.y, 101.0f) << "it falls";
    EXPECT_EQ(positionOf(named("player")).y, 100.0f);
    hands.key(Key::F5);
    EXPECT_FALSE(workspace.play.running());
    EXPECT_EQ(workspace.text(), changed);
    EXPECT_FALSE(workspace.unsaved());
}

TEST_F(EditorWindowTest, theTreeSelectsAndDeleteAndUndoWorkByKeys) {
    hands.click("Scene/sign");
    ASSERT_EQ(workspace.document.selection.all(), std::vector{named("sign")});
    hands.key(Key::Delete);
    EXPECT_FALSE(named("sign"));
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(EditorWindowTest, pauseAndStepPlayOneTickAtATime) {
    hands.click("Toolbar/Play");
    hands.key(Key::F6);
    const std::int64_t before = workspace.play.ticks();
    hands.rest(5);
    EXPECT_EQ(workspace.play.ticks(), before);
    hands.key(Key::F10);
    EXPECT_EQ(workspace.play.ticks(), before + 1);
    hands.click("Toolbar/Play");
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(EditorWindowTest, aValueChangedWhilePlayingIsRestoredAfterwards) {
    hands.click("Scene/crate");
    hands.key(Key::F5);
    hands.enterNumber("Inspector/Transform/position.x", "7");
    EXPECT_EQ(workspace.play.world().get<Transform>(workspace.play.find(named("crate"))).position.x, 7.0f);
    hands.key(Key::F5);
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(EditorWindowTest, everyPanelAndOverlayDrawsAnEmptyAndAFullScene) {
    for (const OverlayRow& row : overlayTable()) {
        if (!workspace.shows(row.name)) workspace.toggleOverlay(row.name);
    }
    workspace.document.selection.set(workspace.document.objects());
    hands.rest(2);
    EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, 1000);
    for (const char* tab : {"Tab/History", "Tab/Tiles", "Tab/Console"}) {
        hands.click(tab);
    }
    workspace.document.selection.set(workspace.document.objects());
    hands.key(Key::Delete);
    EXPECT_EQ(workspace.document.objectCount(), 0u);
    hands.rest(2);
    EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, 100);
}

TEST_F(EditorWindowTest, layersOfThePhysicsAreTickedWhileEditingAndStayWhilePlaying) {
    hands.size = {1280, 1200};  // tall enough to show every row of the list, so that no scrolling is needed
    hands.rest(3);
    const std::string text = workspace.text();
    hands.click("Overlay/physics");
    hands.rest(2);
    EXPECT_EQ(window.widgets().find("Overlay/physics")->value, "on");
    const auto* preview = workspace.document.world.findResource<PhysicsState>();
    ASSERT_NE(preview, nullptr);
    EXPECT_GT(preview->world.shapes.size(), 0u) << "bodies to draw, though the game does not run";
    hands.click("Overlay/physics layers");
    hands.rest(2);
    for (const PhysicsLayer& layer : physicsLayers()) {
        SCOPED_TRACE(layer.name);
        const std::string row = format("Overlay/physics/{}/", layer.name);
        const PhysicsReach first = layer.atFirst ? PhysicsReach::All : PhysicsReach::Off;
        EXPECT_EQ(workspace.physics.reachOf(layer), first);
        if (layer.ofBodies) {
            hands.click(row + "selected");
            EXPECT_EQ(workspace.physics.reachOf(layer), PhysicsReach::Selected);
            EXPECT_EQ(window.widgets().find(row + "selected")->value, "on");
        }
        hands.click(row + (layer.atFirst ? "off" : "all"));
        EXPECT_EQ(workspace.physics.reachOf(layer), layer.atFirst ? PhysicsReach::Off : PhysicsReach::All);
    }
    hands.key(Key::Escape);
    const unsigned chosen = workspace.physics.shown().any();
    EXPECT_NE(chosen, 0u);
    hands.key(Key::F5);
    hands.rest(10);
    ASSERT_TRUE(workspace.play.running());
    EXPECT_EQ(workspace.physics.shown().any(), chosen);
    hands.key(Key::F5);
    hands.key(Key::F3);
    EXPECT_EQ(workspace.physics.shown().any(), 0u);
    EXPECT_EQ(workspace.text(), text) << "looking changed the scene";
}

TEST_F(EditorWindowTest, inTheSaveDialogEnterSavesAndEscapeContinuesEditing) {
    hands.click("Scene/crate");
    hands.key(Key::Delete);
    const std::string text = workspace.text();
    const auto quits = [&] {
        hands.key(Key::Q, {.control = true});
        hands.rest(2);
        EXPECT_NE(window.widgets().find("Unsaved/Save"), nullptr);
    };
    quits();
    hands.key(Key::Escape);
    hands.rest(2);
    EXPECT_TRUE(workspace.unsaved());
    quits();
    hands.key(Key::Enter);
    hands.rest(2);
    EXPECT_TRUE(window.wantsQuit());
    EXPECT_EQ(fileText(), text);
}

TEST_F(EditorWindowTest, aNewSceneIsNamedAndUnsavedChangesAreConfirmed) {
    hands.click("Scene/crate");
    hands.key(Key::Delete);
    hands.key(Key::N, {.control = true, .alt = true});
    hands.rest(2);
    hands.type("cave");
    hands.click("New/Create");
    hands.rest(2);
    ASSERT_NE(window.widgets().find("Unsaved/Discard"), nullptr);
    hands.click("Unsaved/Discard");
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, "scenes/cave.scene.json");
    EXPECT_EQ(fileText(), kSceneText);
}

TEST_F(EditorWindowTest, escapeOnlyClosesTheMenu) {
    workspace.document.selection.set({named("sign")});
    hands.click("Menu/Edit");
    ASSERT_NE(window.widgets().find("Menu/Edit/Delete"), nullptr);
    hands.key(Key::Delete);
    EXPECT_TRUE(named("sign")) << "keys belong to the open menu";

    hands.key(Key::Escape);
    EXPECT_EQ(window.widgets().find("Menu/Edit/Delete"), nullptr);
    EXPECT_EQ(workspace.document.selection.size(), 1u);
    hands.key(Key::Escape);
    EXPECT_TRUE(workspace.document.selection.empty());
}

TEST_F(EditorWindowTest, theViewFollowsTheGameAndIsRestoredAfterwards) {
    const View before = workspace.view.view();
    hands.key(Key::F5);
    hands.rest(5);
    EXPECT_TRUE(workspace.followsGame);
    const Vec2 camera = workspace.play.world().get<Transform>(workspace.play.find(named("camera"))).position;
    EXPECT_LT(distance(workspace.view.view().center, camera), 8.0f);

    const Vec2 middle = hands.middleOf("Viewport");
    hands.moveTo(middle), hands.press(MouseButton::Middle), hands.moveTo(middle + Vec2{30.0f, 0.0f});
    hands.release(MouseButton::Middle);
    EXPECT_FALSE(workspace.followsGame) << "until one looks elsewhere";
    hands.key(Key::F5);
    hands.rest();
    EXPECT_EQ(workspace.view.view().center, before.center);
    EXPECT_EQ(workspace.view.view().zoom, before.zoom);
}

TEST_F(EditorWindowTest, theConsoleShowsMessagesFromBeforeTheWindow) {
    LogBook early;
    logNote("Test", "said early");
    EditorWindow second{workspace, early, nullptr, test::sourceFolder() / "assets/fonts"};
    workspace.settings.layout.show("Console");
    const Hands others{second};
    ASSERT_NE(second.widgets().find("Console/last"), nullptr);
    EXPECT_EQ(second.widgets().find("Console/last")->value, "said early");
}

TEST_F(EditorWindowTest, aPatternIsSelectedInThePaletteAndPaintedInOneStep) {
    Tileset tileset;
    tileset.image = "tiles.png";
    tileset.columns = 4;
    tileset.count = 16;
    workspace.document.world.get<TileLayer>(workspace.document.find(named("ground"))).tileset =
        workspace.assets.addTileset("test", tileset);

    workspace.settings.layout.show("Console");
    hands.rest();
    hands.key(Key::B);
    ASSERT_NE(window.widgets().find("Tiles/palette"), nullptr) << "the palette comes with the brush";
    const auto& box = window.widgets().find("Tiles/palette")->box;
    // the palette fills the width of the panel with four columns
    const float cell = (box.max.x - box.min.x) / 4.0f;
    hands.drag(box.min + Vec2{1.5f, 0.5f} * cell, box.min + Vec2{2.5f, 0.5f} * cell);
    EXPECT_EQ(workspace.tiles.stamp, (TileStamp{2, 1, {cellOf(1), cellOf(2)}}));

    hands.drag(onScreen({8.0f, 8.0f}), onScreen({40.0f, 8.0f}));
    const TileLayer& layer =
        std::as_const(workspace.document.world).get<TileLayer>(workspace.document.find(named("ground")));
    const TileGrid& grid = *workspace.document.world.tiles().find(layer.cells);
    for (int x = 0; x < 4; ++x) {
        EXPECT_EQ(grid.at(x, 0), cellOf(1 + x % 2)) << x;
    }
    EXPECT_EQ(workspace.undo.size(), 1u);
    hands.key(Key::Q);
    EXPECT_EQ(window.widgets().find("Tiles/palette"), nullptr) << "and goes with it";
}

TEST_F(EditorWindowTest, aLayerIsMadeLargerInTheInspectorAndUndone) {
    hands.click("Scene/ground");
    hands.click("Inspector/TileLayer/cells.width");
    hands.key(Key::A, {.control = true});
    hands.type("6");
    hands.key(Key::Enter);
    const auto width = [&] {
        const EntityId ground = workspace.document.find(named("ground"));
        return workspace.document.world.tiles()
            .find(std::as_const(workspace.document.world).get<TileLayer>(ground).cells)
            ->width();
    };
    EXPECT_EQ(width(), 6);
    workspace.undo.undo();
    EXPECT_EQ(width(), 4);
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(EditorWindowTest, overridesOfAnInstanceAreMarkedAndRevertedByAMenu) {
    putFile("prefabs/box.prefab.json", R"({"format": 1, "entities": [{"name": "box", "components": {
        "Transform": {}, "Sprite": {"width": 8, "height": 16}}}]})");
    putFile("scenes/boxes.scene.json", R"({"format": 1, "entities": [{"id": "00000000000000a1",
        "prefab": "prefabs/box.prefab.json", "components": {"Sprite": {"height": 30}}}]})");
    ASSERT_TRUE(workspace.open("scenes/boxes.scene.json").ok());
    hands.rest();
    hands.click("Scene/box");
    EXPECT_EQ(window.widgets().find("Inspector/prefab")->value, "1");
    EXPECT_EQ(window.widgets().find("Inspector/Sprite/width/label")->value, "");
    ASSERT_EQ(window.widgets().find("Inspector/Sprite/height/label")->value, "overridden");

    hands.clickAt(hands.middleOf("Inspector/Sprite/height/label"), MouseButton::Right);
    hands.click("Inspector/Sprite/height/revert");

    EXPECT_EQ(window.widgets().find("Inspector/prefab")->value, "0");
    const ObjectId box = workspace.document.objects().front();
    EXPECT_EQ(std::as_const(workspace.document.world).get<Sprite>(workspace.document.find(box)).height, 16);
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(EditorWindowTest, aMonkeyAtTheWidgetsIsUndoneByteForByte) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        for (int i = 0; i < 60; ++i) {
            std::vector<std::string> names;
            for (const auto& [name, widget] : window.widgets().all()) {
                const bool leaves = startsWith(name, "Menu/") || startsWith(name, "Toolbar/Save") ||
                                    startsWith(name, "Toolbar/Play") || startsWith(name, "Finder/") ||
                                    startsWith(name, "Import/") || name == "Assets/Import";
                if (!leaves) names.push_back(name);
            }
            const Vec2 at = hands.middleOf(names[random.below(static_cast<std::uint32_t>(names.size()))]);
            if (random.below(2) == 0) {
                hands.clickAt(at);
            } else {
                hands.drag(at, at + Vec2{random.between(-60.0f, 60.0f), random.between(-30.0f, 30.0f)}, 4);
            }
            if (random.below(6) == 0) hands.key(Key::Delete);
            if (random.below(6) == 0) hands.key(Key::D, {.control = true});
        }
        hands.key(Key::Escape);
        hands.key(Key::Escape);
        const std::string after = workspace.text();
        const std::size_t steps = workspace.undo.size();
        workspace.undo.jumpTo(0);
        ASSERT_EQ(workspace.text(), kSceneText);
        workspace.undo.jumpTo(steps);
        ASSERT_EQ(workspace.text(), after);
        workspace.undo.jumpTo(0);
    }
}

}  // namespace
}  // namespace plumb::editor::ui
