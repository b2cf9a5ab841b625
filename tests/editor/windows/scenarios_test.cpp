// Long sessions: builds, plays, changes and saves levels of a real project by mouse and keys alone. The tests
// check the saved files and the visible state on the way.

#include "editor/model/document/tile_layers.hpp"
#include "editor/model/input/key_bindings.hpp"
#include "editor/model/project/project_session.hpp"
#include "editor/templates/project_templates.hpp"
#include "scene/components.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor::ui {
namespace {

/// A project created from the template "Platformer", open in the whole editor.
class Designer : public testing::Test {
protected:
    Designer() {
        for (const ProjectTemplate& row : projectTemplates()) {
            if (row.id != "platformer") continue;
            EXPECT_TRUE(createProject(row, "My Game", root_).ok());
        }
        start();
    }
    /// Starts the editor, or restarts it.
    void start(std::string_view scene = {}) {
        hands_.reset(), window_.reset(), session_.reset();
        Result<std::unique_ptr<ProjectSession>> session = ProjectSession::open(root_.string());
        ASSERT_TRUE(session.ok());
        session_ = std::move(*session);
        session_->openFirst(scene);
        window_ = std::make_unique<EditorWindow>(session_->workspace(), log_, nullptr,
                                                 test::sourceFolder() / "assets/fonts");
        hands_ = std::make_unique<Hands>(*window_);
    }
    [[nodiscard]] Workspace& w() { return session_->workspace(); }
    [[nodiscard]] Hands& hands() { return *hands_; }
    [[nodiscard]] const EditorWindow& window() const { return *window_; }

    void press(std::string_view keys) {
        const Shortcut shortcut = *shortcutFromText(keys);
        hands().key(shortcut.key, {shortcut.shift, shortcut.control, shortcut.alt});
        hands().rest(2);
    }
    [[nodiscard]] bool shown(std::string_view widget) const {
        return window_->widgets().find(widget) != nullptr;
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        EXPECT_TRUE(shown(widget)) << widget << " is not on the screen";
        return shown(widget) ? window_->widgets().find(widget)->value : std::string{};
    }
    [[nodiscard]] Vec2 onScreen(Vec2 world) {
        return window_->widgets().find("Viewport")->box.min + w().view.toScreenPoint(world);
    }
    void drag(Vec2 from, Vec2 to) { hands().drag(onScreen(from), onScreen(to)); }
    [[nodiscard]] ObjectId named(std::string_view name) {
        for (const ObjectId id : w().document.objects()) {
            if (w().document.nameOf(id) == name) return id;
        }
        return {};
    }
    [[nodiscard]] std::vector<ObjectId> allNamed(std::string_view name) {
        std::vector<ObjectId> ids;
        for (const ObjectId id : w().document.objects()) {
            if (w().document.nameOf(id) == name) ids.push_back(id);
        }
        return ids;
    }
    template <class T>
    [[nodiscard]] const T& of(ObjectId id) {
        return std::as_const(w().document.world).get<T>(w().document.find(id));
    }
    [[nodiscard]] std::string file(std::string_view path) { return *readFile(root_ / path); }

    void newScene(std::string_view name) {
        press("Ctrl+Alt+N");
        hands().type(name);
        hands().key(Key::Enter);
        hands().rest(3);
        ASSERT_EQ(w().document.scenePath, format("scenes/{}.scene.json", name));
    }
    /// Drags a file from the asset browser into the scene. Uses the search, because there are too many files
    /// to show.
    void dropFile(std::string_view path, Vec2 place) {
        hands().click("Tab/Assets");
        hands().rest(40);
        hands().click("Assets/search");
        press("Ctrl+A");
        hands().type(path.substr(path.rfind('/') + 1));
        hands().rest(3);
        hands().drag(hands().middleOf(format("Assets/{}", path)), onScreen(place));
        hands().rest(2);
    }
    /// Folds components, so that the ones below become visible in the inspector.
    void fold(std::initializer_list<const char*> components) {
        for (const char* name : components) {
            hands().click(format("Inspector/{}", name));
            hands().rest();
        }
    }
    /// Expects that undoing and redoing the whole history restores the bytes.
    void expectHistoryIsExact(const std::string& start) {
        const std::string now = w().text();
        const std::size_t steps = w().undo.size();
        for (std::size_t i = 0; i < steps; ++i) press("Ctrl+Z");
        EXPECT_EQ(w().text(), start);
        EXPECT_EQ(w().undo.size(), 0u);
        for (std::size_t i = 0; i < steps; ++i) press("Ctrl+Y");
        EXPECT_EQ(w().text(), now);
    }

private:
    test::TemporaryFolder folder_;
    Path root_ = folder_.path / "my-game";
    LogBook log_;
    std::unique_ptr<ProjectSession> session_;
    std::unique_ptr<EditorWindow> window_;
    std::unique_ptr<Hands> hands_;
};

TEST_F(Designer, buildsALevelPlaysItKeepsAChangeSavesAndComesBack) {
    newScene("cave");
    const std::string empty = w().text();
    EXPECT_TRUE(shown("Scene/empty")) << "an empty scene says what to do";

    // Ground: a dropped tileset becomes a tile layer, on which terrain is painted.
    dropFile("assets/wood.tileset.json", {0.0f, 0.0f});
    ASSERT_EQ(w().undo.size(), 1u) << w().notice;
    const ObjectId ground = w().document.selection.all().back();
    const Vec2 corner = of<Transform>(ground).position;
    press("T");
    EXPECT_TRUE(shown("Tiles/terrain/ground"));
    const auto middle = [&](int x, int y) {
        return corner + Vec2{static_cast<float>(x) * 16.0f + 8.0f, static_cast<float>(y) * 16.0f + 8.0f};
    };
    hands().held = {.shift = true, .control = true};
    drag(middle(0, 6), middle(20, 8));
    hands().held = {};
    ASSERT_EQ(w().undo.size(), 2u) << "a box of terrain is one step";
    const TileGrid& grid = *gridOf(w().document, ground);
    EXPECT_EQ(grid.at(10, 5), 0u);
    EXPECT_NE(grid.at(10, 6), 0u);
    EXPECT_NE(grid.at(10, 6), grid.at(10, 7)) << "its upper side looks other than its inside";
    press("Q");

    // Player and enemies.
    dropFile("prefabs/player.prefab.json", middle(2, 5));
    dropFile("prefabs/gloomcap.prefab.json", middle(8, 5));
    const ObjectId enemy = w().document.selection.all().back();
    EXPECT_EQ(w().document.nameOf(enemy), "gloomcap");
    press("Ctrl+D");
    for (int i = 0; i < 4; ++i) press("Shift+Right");
    const std::vector<ObjectId> enemies = allNamed("gloomcap");
    ASSERT_EQ(enemies.size(), 2u);
    EXPECT_EQ(of<Transform>(enemies[1]).position.x, of<Transform>(enemies[0]).position.x + 64.0f);
    const std::size_t before = w().undo.size();
    EXPECT_EQ(before, 6u) << "layer, terrain, player, enemy, copy, one run of nudges";

    // Double the speed of both enemies in one step; each keeps its own base value.
    w().document.selection.set(enemies);
    hands().rest(2);
    fold({"Transform", "Sprite", "Animator", "KinematicBody", "BoxCollider"});
    EXPECT_EQ(valueOf("Inspector/Patrol/speed"), "28");
    hands().enterNumber("Inspector/Patrol/speed", "*2");
    EXPECT_EQ(w().undo.size(), before + 1);
    EXPECT_EQ(valueOf("Inspector/Patrol/speed"), "56");
    EXPECT_EQ(valueOf("Inspector/Patrol/speed/label"), "overridden") << "they differ from their prefab";

    // Play the level and move an enemy meanwhile.
    const std::string edited = w().text();
    press("F5");
    hands().rest(30);
    ASSERT_TRUE(w().play.running()) << w().notice;
    press("F6");
    w().document.selection.set({enemies[1]});
    hands().rest(2);
    hands().enterNumber("Inspector/Patrol/speed", "40");
    EXPECT_EQ(w().text(), edited) << "the scene is not touched while it plays";
    press("F5");
    EXPECT_EQ(valueOf("Keep/keep"), "1");
    hands().click("Keep/keep");
    hands().rest(2);
    EXPECT_EQ(w().undo.size(), before + 2);
    EXPECT_NE(w().text().find("\"speed\": 40"), std::string::npos);
    EXPECT_NE(w().text().find("\"speed\": 56"), std::string::npos) << "the other one stays";

    // Undo and redo everything, save, and check the level after a restart.
    expectHistoryIsExact(empty);
    const std::string done = w().text();
    EXPECT_NE(valueOf("Status/state").find("Not saved"), std::string::npos);
    press("Ctrl+S");
    EXPECT_EQ(file("scenes/cave.scene.json"), done);
    EXPECT_EQ(valueOf("Status/state").find("Not saved"), std::string::npos);
    start("cave");
    EXPECT_EQ(w().text(), done);
    EXPECT_FALSE(w().unsaved());
    for (const char* row : {"Scene/player", "Scene/gloomcap"}) EXPECT_TRUE(shown(row)) << row;
    press("F5");
    hands().rest(60);
    EXPECT_TRUE(w().play.running());
    press("F5");
    press("Ctrl+S");
    EXPECT_EQ(file("scenes/cave.scene.json"), done) << "opened, played and saved: not a byte";
}

TEST_F(Designer, rearrangesALevelInTheTreeAndUndoesEverything) {
    start("level1");
    const std::string original = file("scenes/level1.scene.json");
    ASSERT_EQ(w().text(), original);

    // Make a named group of three trees and move it behind the sky in the tree.
    press("Ctrl+F");
    hands().type("tree");
    hands().rest(2);
    EXPECT_FALSE(shown("Scene/sky"));
    hands().key(Key::Enter);
    hands().rest(2);
    const std::vector<ObjectId> trees = allNamed("tree");
    ASSERT_EQ(trees.size(), 3u);
    w().document.selection.set(trees);
    hands().rest(2);
    hands().click("Scene/filter/clear");
    press("Ctrl+G");
    press("F2");
    hands().type("grove");
    hands().key(Key::Enter);
    hands().rest(2);
    const ObjectId grove = named("grove");
    ASSERT_TRUE(grove);
    EXPECT_EQ(w().undo.size(), 2u);
    EXPECT_TRUE(shown("Scene/grove"));

    // Duplicate the group with its trees.
    w().document.selection.set({grove});
    hands().rest(2);
    press("Ctrl+D");
    EXPECT_EQ(allNamed("grove").size(), 2u);
    EXPECT_EQ(allNamed("tree").size(), 6u);
    EXPECT_EQ(w().undo.size(), 3u);

    // Override a value of one coin's prefab, find it in the list of overrides and revert it.
    const std::vector<ObjectId> coins = allNamed("coin");
    ASSERT_GT(coins.size(), 3u);
    w().document.selection.set({coins[0]});
    hands().rest(2);
    const std::string unchanged = w().text();
    hands().enterNumber("Inspector/Transform/scale.x", "3");
    EXPECT_NE(w().text(), unchanged);
    press("Ctrl+Z");
    EXPECT_EQ(w().text(), unchanged);

    // Align three coins, delete them, and restore them by undo.
    w().document.selection.set({coins[0], coins[1], coins[2]});
    hands().rest(2);
    hands().click("Menu/Arrange");
    hands().click("Menu/Arrange/Align top edges");
    hands().rest(2);
    EXPECT_EQ(of<Transform>(coins[0]).position.y, of<Transform>(coins[1]).position.y);
    EXPECT_EQ(of<Transform>(coins[0]).position.y, of<Transform>(coins[2]).position.y);
    press("Delete");
    EXPECT_EQ(allNamed("coin").size(), coins.size() - 3);
    press("Ctrl+Z");
    EXPECT_EQ(allNamed("coin").size(), coins.size());

    // Hide and lock an entity: this is neither saved in the file nor an undo step.
    const std::size_t steps = w().undo.size();
    w().document.selection.set({named("sky")});
    hands().rest(2);
    press("Ctrl+H"), press("Ctrl+L");
    EXPECT_EQ(valueOf("Scene/sky/eye"), "on");
    EXPECT_EQ(valueOf("Scene/sky/lock"), "on");
    EXPECT_EQ(w().undo.size(), steps);

    expectHistoryIsExact(original);
    for (std::size_t i = 0; i < steps; ++i) press("Ctrl+Z");
    EXPECT_FALSE(w().unsaved()) << "as it is in the file";
    press("Ctrl+S");
    EXPECT_EQ(file("scenes/level1.scene.json"), original);
}

TEST_F(Designer, paintsALevelOnLayersWithStampsAndFindsItAgain) {
    start("level1");
    press("Alt+1");
    press("B");
    const ObjectId ground = activeTileLayer(w().document, w().tiles);
    ASSERT_EQ(w().document.nameOf(ground), "ground");
    w().view.show({160.0f, 90.0f}, 2.0f);
    hands().rest(2);
    const auto middle = [](int x, int y) {
        return Vec2{static_cast<float>(x) * 16.0f + 8.0f, static_cast<float>(y) * 16.0f + 8.0f};
    };
    const auto at = [&](ObjectId layer, int x, int y) { return gridOf(w().document, layer)->at(x, y); };

    // Take a stamp from the ground with the right button, store it as 1, and paint it elsewhere.
    hands().moveTo(onScreen(middle(3, 9))), hands().rest(), hands().press(MouseButton::Right);
    hands().moveTo(onScreen(middle(4, 10))), hands().moveTo(onScreen(middle(5, 11)));
    hands().release(MouseButton::Right), hands().rest();
    const TileStamp taken = w().tiles.stamp;
    EXPECT_EQ(taken.width, 3);
    EXPECT_EQ(taken.height, 3);
    EXPECT_EQ(taken.at(2, 2), at(ground, 5, 11));
    press("Ctrl+1");
    press("X"), press("Z");
    EXPECT_EQ(w().tiles.stamp, turned(flippedX(taken)));
    press("1");
    EXPECT_EQ(w().tiles.stamp, taken);
    hands().clickAt(onScreen(middle(8, 3)));
    hands().rest(2);
    ASSERT_EQ(w().undo.size(), 1u);

    // Add a translucent layer above the ground with some leaves, then lower it.
    hands().click("Menu/Tiles");
    hands().click("Menu/Tiles/Add layer");
    hands().rest(3);
    const ObjectId above = w().tiles.layer;
    ASSERT_NE(above, ground);
    EXPECT_EQ(valueOf("Tiles/layers/" + w().document.nameOf(above)), "in hand");
    w().tiles.stamp = {1, 1, {cellOf(5)}};
    press("U");
    drag(middle(2, 2), middle(5, 4));
    EXPECT_EQ(at(above, 5, 4), cellOf(5));
    EXPECT_NE(at(ground, 5, 4), cellOf(5));
    press("H");
    EXPECT_TRUE(w().document.view.hides(ground));
    press("H");
    const AABB slider = window().widgets().find("Tiles/layer/opacity")->box;
    hands().drag(slider.center(), slider.center() - Vec2{slider.size().x * 0.25f, 0.0f});
    EXPECT_LT(of<TileLayer>(above).tint.a, 200);
    press("Ctrl+Shift+PageDown");
    EXPECT_EQ(tileLayers(w().document)[1], above) << "one place lower";

    // Move some tiles, copy some to the other layer and cut the rest.
    press("M");
    drag(middle(2, 2), middle(3, 2));
    drag(middle(2, 2), middle(2, 1));
    EXPECT_EQ(at(above, 2, 1), cellOf(5));
    EXPECT_EQ(at(above, 2, 2), 0u);
    press("Ctrl+C");
    hands().click("Tiles/layers/ground");
    hands().rest();
    ASSERT_EQ(activeTileLayer(w().document, w().tiles), ground);
    press("Ctrl+V");
    hands().clickAt(onScreen(middle(9, 5)));
    hands().rest(2);
    EXPECT_EQ(at(ground, 9, 5), cellOf(5)) << "from one layer to the other";

    const std::string done = w().text();
    press("Ctrl+S");
    start("level1");
    EXPECT_EQ(w().text(), done);
    const std::vector<ObjectId> layers = tileLayers(w().document);
    EXPECT_NE(std::find(layers.begin(), layers.end(), above), layers.end()) << "it has kept its id";
    EXPECT_EQ(at(above, 2, 1), cellOf(5));
}

}  // namespace
}  // namespace plumb::editor::ui
