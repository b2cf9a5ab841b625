#include <array>

#include "scene/components/colliders/polygon_collider.hpp"
#include "tests/editor/keys/desk.hpp"

namespace plumb::editor::ui {
namespace {

/// Expects that the keys undo change().
void undoes(KeyTrials& at) {
    at.change();
    at.press();
    EXPECT_EQ(at.workspace.text(), kSceneText);
}
void redoes(KeyTrials& at) {
    at.change();
    const std::string changed = at.workspace.text();
    at.workspace.undo.undo();
    at.press();
    EXPECT_EQ(at.workspace.text(), changed);
}

void deletes(KeyTrials& at) {
    at.select({"crate", "sign"});
    at.press();
    EXPECT_EQ(at.count("crate") + at.count("sign"), 0);
    at.press("Ctrl+Z");
    EXPECT_EQ(at.workspace.text(), kSceneText);
}

void takesCornerOut(KeyTrials& at) {
    World& world = at.workspace.document.world;
    const EntityId crate = at.workspace.document.find(at.named("crate"));
    world.remove<BoxCollider>(crate);
    auto& polygon = world.add<PolygonCollider>(crate);
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{40, 0}, Vec2{40, 40}, Vec2{0, 40}})
        polygon.points.push(corner);
    at.select({"crate"});
    at.press("C");
    at.hands.clickAt(at.onScreen({240.0f, 64.0f}));
    at.press();
    EXPECT_EQ(at.count("crate"), 1);
    EXPECT_EQ(std::as_const(world).get<PolygonCollider>(crate).points.size(), 3u);
}

constexpr std::array kTrials{
    KeyTrial{"Ctrl+Alt+N", "file.new",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("New/name"));
             }},
    KeyTrial{"Ctrl+O", "file.open",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("Finder/level.scene.json"));
             }},
    KeyTrial{"Ctrl+S", "file.save",
             [](KeyTrials& at) {
                 at.change();
                 at.press();
                 EXPECT_EQ(at.fileText(), at.workspace.text());
                 EXPECT_NE(at.fileText(), kSceneText);
                 EXPECT_FALSE(at.workspace.unsaved());
             }},
    KeyTrial{"Ctrl+Shift+S", "file.saveAs",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("SaveAs/name"));
             }},
    KeyTrial{"Ctrl+Alt+B", "file.backups",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("Backups/cancel"));
             }},
    KeyTrial{"Ctrl+Shift+I", "file.import",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("Import/place"));
             }},
    KeyTrial{"Ctrl+Shift+O", "file.welcome",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("Welcome/Create"));
             }},
    KeyTrial{"Ctrl+Q", "file.quit",
             [](KeyTrials& at) {
                 at.change();
                 at.press();
                 EXPECT_FALSE(at.window.wantsQuit()) << "what is not saved is asked for";
                 at.hands.click("Unsaved/Discard");
                 EXPECT_TRUE(at.window.wantsQuit());
             }},
    KeyTrial{"Ctrl+Z", "edit.undo", undoes},
    KeyTrial{"Ctrl+Y", "edit.redo", redoes},
    KeyTrial{"Ctrl+Shift+Z", "edit.redo", redoes},
    KeyTrial{"Ctrl+X", "edit.cut",
             [](KeyTrials& at) {
                 at.select({"crate"});
                 at.press();
                 EXPECT_EQ(at.count("crate"), 0);
                 EXPECT_NE(at.workspace.clipboard.find("crate"), std::string::npos);
             }},
    KeyTrial{"Ctrl+C", "edit.copy",
             [](KeyTrials& at) {
                 at.select({"crate"});
                 at.press();
                 EXPECT_NE(at.workspace.clipboard.find("crate"), std::string::npos);
                 EXPECT_EQ(at.workspace.text(), kSceneText);
             }},
    KeyTrial{"Ctrl+V", "edit.paste",
             [](KeyTrials& at) {
                 at.select({"crate"});
                 at.press("Ctrl+C");
                 at.press();
                 EXPECT_EQ(at.count("crate"), 2);
                 EXPECT_EQ(at.workspace.undo.size(), 1u);
             }},
    KeyTrial{"Ctrl+D", "edit.duplicate",
             [](KeyTrials& at) {
                 at.select({"crate", "sign"});
                 at.press();
                 EXPECT_EQ(at.count("crate"), 2);
                 EXPECT_EQ(at.count("sign"), 2);
                 EXPECT_EQ(at.workspace.undo.size(), 1u);
             }},
    KeyTrial{"Delete", "edit.delete", deletes},
    KeyTrial{"Backspace", "edit.delete", deletes},
    KeyTrial{"Delete", "shape.remove", takesCornerOut},
    KeyTrial{"Backspace", "shape.remove", takesCornerOut},
    KeyTrial{"Ctrl+A", "edit.selectAll",
             [](KeyTrials& at) {
                 at.workspace.document.view.setLocked(at.named("sign"), true);
                 at.press();
                 EXPECT_EQ(at.workspace.document.selection.size(), 5u) << "all but what is locked";
             }},
    KeyTrial{"Ctrl+P", "edit.find",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_EQ(at.valueOf("Finder/typed"), "");
             }},
    KeyTrial{"Ctrl+Shift+P", "edit.commands",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("Finder/typed"));
                 at.hands.type("undo");
                 at.hands.rest();
                 EXPECT_TRUE(at.shown("Finder/Undo"));
             }},
    KeyTrial{"Ctrl+F", "edit.filter",
             [](KeyTrials& at) {
                 at.press("Tab");
                 at.press();
                 at.hands.type("lamp");
                 at.hands.rest();
                 EXPECT_EQ(at.valueOf("Scene/filter"), "lamp") << "also when the panels were hidden";
                 EXPECT_TRUE(at.shown("Scene/lamp"));
                 EXPECT_FALSE(at.shown("Scene/crate"));
             }},
    KeyTrial{"Escape", "edit.escape",
             [](KeyTrials& at) {
                 at.select({"crate"});
                 at.press();
                 EXPECT_TRUE(at.workspace.document.selection.empty());
                 EXPECT_EQ(at.workspace.undo.size(), 0u);
             }},
    KeyTrial{"F1", "edit.keys",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_EQ(at.valueOf("Preferences/Keys/edit.undo"), "Ctrl+Z");
             }},
    KeyTrial{"Ctrl+Comma", "edit.preferences",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_TRUE(at.shown("Preferences/Close"));
             }},
};

}  // namespace

std::span<const KeyTrial> fileAndEditTrials() { return kTrials; }

}  // namespace plumb::editor::ui
