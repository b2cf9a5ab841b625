#pragma once

#include <span>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/input/key_bindings.hpp"
#include "editor/model/play/game_session.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {

/// The whole editor without a screen, controlled by simulated input, with the scene of EditorFixture open.
class Desk : public EditorFixture {
public:
    Desk() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            return makeGameSession(project, path, text);
        };
    }
    using EditorFixture::fileText;
    using EditorFixture::named;
    using EditorFixture::positionOf;
    using EditorFixture::putFile;
    using EditorFixture::workspace;

    void press(Shortcut keys) { hands.key(keys.key, {keys.shift, keys.control, keys.alt}), hands.rest(2); }
    void press(std::string_view keys) { press(*shortcutFromText(keys)); }

    void select(std::initializer_list<const char*> names) {
        std::vector<ObjectId> ids;
        for (const char* name : names) ids.push_back(named(name));
        workspace.document.selection.set(std::move(ids));
        hands.rest(2);
    }
    [[nodiscard]] bool selects(std::initializer_list<const char*> names) const {
        std::vector<ObjectId> ids;
        for (const char* name : names) ids.push_back(named(name));
        return workspace.document.selection.all() == ids;
    }
    // Input events that `hands` has no functions for.

    void send(const Event& event) { window.frame({std::span{&event, 1}}); }
    void hold(Key key, Modifiers modifiers = {}) {
        send({.kind = EventKind::KeyDown, .key = key, .modifiers = modifiers}), hands.rest();
    }
    void letGo(Key key) { send({.kind = EventKind::KeyUp, .key = key}), hands.rest(); }
    void wheel(float notches) {
        send({.kind = EventKind::MouseWheel, .motion = {0.0f, notches}}), hands.rest();
    }
    /// Double-clicks. Waits first, so that an earlier click is not counted as the first of the two.
    void doubleClickAt(Vec2 at) {
        hands.rest(30), hands.moveTo(at), hands.rest();
        hands.press(), hands.release(), hands.press(), hands.release(), hands.rest(2);
    }
    /// Moves the mouse in ten steps; buttons and keys that are held stay held.
    void dragOn(Vec2 from, Vec2 to) {
        for (int i = 1; i <= 10; ++i) hands.moveTo(lerp(from, to, static_cast<float>(i) / 10.0f));
    }
    void dragWith(MouseButton button, Vec2 from, Vec2 to) {
        hands.moveTo(from), hands.rest(), hands.press(button);
        dragOn(from, to);
        hands.release(button), hands.rest();
    }

    /// Number of entities with this name.
    [[nodiscard]] int count(std::string_view name) const {
        int found = 0;
        for (const ObjectId id : workspace.document.objects())
            found += workspace.document.nameOf(id) == name ? 1 : 0;
        return found;
    }
    [[nodiscard]] bool shown(std::string_view widget) const {
        return window.widgets().find(widget) != nullptr;
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        EXPECT_TRUE(shown(widget)) << widget << " is not on the screen";
        return shown(widget) ? window.widgets().find(widget)->value : std::string{};
    }
    /// Converts a position in the scene to window coordinates, px.
    [[nodiscard]] Vec2 onScreen(Vec2 world) const {
        return window.widgets().find("Viewport")->box.min + workspace.view.toScreenPoint(world);
    }
    [[nodiscard]] std::string_view toolInHand() const { return toolTable()[workspace.toolIndex()].action; }
    /// Moves the crate by 8 px to the right as one undo step.
    void change() {
        select({"crate"});
        hands.enterNumber("Inspector/Transform/position.x", "208");
        ASSERT_EQ(workspace.undo.size(), 1u);
    }
    /// Selects the brush with tile 1 on the scene's tile layer: 4 x 3 cells of 16 px, with a full last row.
    void takeBrush() {
        workspace.useTool("tool.brush");
        workspace.tiles.stamp = {1, 1, {cellOf(1)}};
        hands.rest(2);
    }
    [[nodiscard]] const TileGrid& grid() const {
        return *gridOf(workspace.document, activeTileLayer(workspace.document, workspace.tiles));
    }
    [[nodiscard]] static Vec2 cell(int x, int y) {
        return {static_cast<float>(x) * 16.0f + 8.0f, static_cast<float>(y) * 16.0f + 8.0f};
    }
    /// Returns a row of cells of the active layer as digits, for example "0110".
    [[nodiscard]] std::string row(int y) const {
        std::string text;
        for (int x = 0; x < grid().width(); ++x) text += std::to_string(grid().at(x, y));
        return text;
    }
    /// Opens a scene with a prefab instance that overrides the sprite height 16 of its prefab by 30.
    void openInstance() {
        putFile("prefabs/box.prefab.json", R"({"format": 1, "entities": [{"name": "box", "components": {
            "Transform": {}, "Sprite": {"width": 8, "height": 16}}}]})");
        putFile("scenes/boxes.scene.json", R"({"format": 1, "entities": [{"id": "00000000000000a1",
            "prefab": "prefabs/box.prefab.json", "components": {"Sprite": {"height": 30}}}]})");
        ASSERT_TRUE(workspace.open("scenes/boxes.scene.json").ok());
        select({"box"});
    }
    void play(int frames) {
        workspace.startPlaying();
        hands.rest(frames);
        ASSERT_TRUE(workspace.play.running());
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

/// Key presses, the action that they must trigger, and the function that presses them in the real window and
/// checks the effect.
struct KeyTrial {
    std::string_view keys;
    std::string_view action;
    void (*attempt)(class KeyTrials& at) = nullptr;
};

/// Prints the trial in failure messages of GoogleTest.
inline void PrintTo(const KeyTrial& trial, std::ostream* out) { *out << trial.action << " " << trial.keys; }

class KeyTrials : public Desk, public testing::WithParamInterface<KeyTrial> {
public:
    /// Presses the keys of the current trial.
    void press() { Desk::press(GetParam().keys); }
    using Desk::press;
};

// Trials, grouped by menu.
std::span<const KeyTrial> fileAndEditTrials();
std::span<const KeyTrial> entityTrials();
std::span<const KeyTrial> toolAndTileTrials();
std::span<const KeyTrial> viewAndRunTrials();

}  // namespace plumb::editor::ui
