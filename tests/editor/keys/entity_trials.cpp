#include <array>

#include "ecs/hierarchy.hpp"
#include "tests/editor/keys/desk.hpp"

namespace plumb::editor::ui {
namespace {

/// Expects that three taps move the crate three times and are one undo step.
template <int X, int Y>
void nudges(KeyTrials& at) {
    at.select({"crate"});
    for (int i = 0; i < 3; ++i) at.press();
    const Vec2 by{static_cast<float>(X), static_cast<float>(Y)};
    EXPECT_EQ(at.positionOf(at.named("crate")), (Vec2{200.0f, 64.0f} + by * 3.0f));
    EXPECT_EQ(at.workspace.undo.size(), 1u);
    at.press("Ctrl+Z");
    EXPECT_EQ(at.workspace.text(), kSceneText);
}

/// Expects that the keys move the sign by `By` siblings in the tree.
template <int By>
void stepsInTree(KeyTrials& at) {
    const auto placeOf = [&](const char* name) {
        const auto& all = at.workspace.document.objects();
        return std::find(all.begin(), all.end(), at.named(name)) - all.begin();
    };
    at.select({"sign"});
    const auto before = placeOf("sign");
    at.press();
    EXPECT_EQ(placeOf("sign"), before + By);
}

constexpr std::array kTrials{
    KeyTrial{"Ctrl+N", "entity.create",
             [](KeyTrials& at) {
                 at.press();
                 EXPECT_EQ(at.count("new entity"), 1);
             }},
    KeyTrial{"Ctrl+Shift+N", "entity.prefab",
             [](KeyTrials& at) {
                 at.openInstance();
                 at.press();
                 at.hands.click("Finder/box.prefab.json");
                 EXPECT_EQ(at.count("box"), 2);
             }},
    KeyTrial{"F2", "entity.rename",
             [](KeyTrials& at) {
                 at.select({"sign"});
                 at.press();
                 at.hands.type("board");
                 at.hands.key(Key::Enter);
                 EXPECT_TRUE(at.selects({"board"}));
             }},
    KeyTrial{"Ctrl+G", "entity.group",
             [](KeyTrials& at) {
                 at.select({"crate", "sign"});
                 at.press();
                 const Document& document = at.workspace.document;
                 for (const char* name : {"crate", "sign"})
                     EXPECT_EQ(document.idOf(parentOf(document.world, document.find(at.named(name)))),
                               at.named("group"));
             }},
    KeyTrial{"Alt+Up", "entity.earlier", stepsInTree<-1>},
    KeyTrial{"Alt+Down", "entity.later", stepsInTree<1>},
    KeyTrial{"Ctrl+H", "entity.hide",
             [](KeyTrials& at) {
                 at.select({"crate"});
                 at.press();
                 EXPECT_TRUE(at.workspace.document.view.isHidden(at.named("crate")));
                 EXPECT_EQ(at.valueOf("Scene/crate/eye"), "on");
                 at.press();
                 EXPECT_FALSE(at.workspace.document.view.isHidden(at.named("crate")));
             }},
    KeyTrial{"Ctrl+L", "entity.lock",
             [](KeyTrials& at) {
                 at.select({"crate"});
                 at.press();
                 EXPECT_EQ(at.valueOf("Scene/crate/lock"), "on");
                 at.workspace.document.selection.clear();
                 at.hands.clickAt(at.onScreen({216.0f, 80.0f}));
                 EXPECT_TRUE(at.workspace.document.selection.empty()) << "clicks go through it";
             }},
    KeyTrial{"Ctrl+Alt+H", "entity.showAll",
             [](KeyTrials& at) {
                 at.workspace.document.view.setHidden(at.named("crate"), true);
                 at.workspace.document.view.setLocked(at.named("sign"), true);
                 at.press();
                 EXPECT_TRUE(at.workspace.document.view.showsAll());
             }},
    KeyTrial{"Ctrl+R", "entity.revert",
             [](KeyTrials& at) {
                 at.openInstance();
                 at.press();
                 EXPECT_EQ(at.valueOf("Inspector/prefab"), "0");
                 EXPECT_EQ(at.valueOf("Inspector/Sprite/height"), "16");
             }},
    KeyTrial{"Ctrl+Shift+R", "entity.apply",
             [](KeyTrials& at) {
                 at.openInstance();
                 at.press();
                 EXPECT_EQ(at.valueOf("Inspector/prefab"), "0");
                 EXPECT_EQ(at.valueOf("Inspector/Sprite/height"), "30");
                 EXPECT_NE(at.fileText("prefabs/box.prefab.json").find("30"), std::string::npos);
             }},
    KeyTrial{"Ctrl+E", "entity.editPrefab",
             [](KeyTrials& at) {
                 at.openInstance();
                 at.press();
                 EXPECT_EQ(at.workspace.document.scenePath, "prefabs/box.prefab.json");
             }},
    KeyTrial{"Ctrl+Shift+E", "entity.leavePrefab",
             [](KeyTrials& at) {
                 at.openInstance();
                 at.press("Ctrl+E");
                 at.press();
                 EXPECT_EQ(at.workspace.document.scenePath, "scenes/boxes.scene.json");
             }},
    KeyTrial{"Left", "entity.left", nudges<-1, 0>},
    KeyTrial{"Right", "entity.right", nudges<1, 0>},
    KeyTrial{"Up", "entity.up", nudges<0, -1>},
    KeyTrial{"Down", "entity.down", nudges<0, 1>},
    KeyTrial{"Shift+Left", "entity.gridLeft", nudges<-16, 0>},
    KeyTrial{"Shift+Right", "entity.gridRight", nudges<16, 0>},
    KeyTrial{"Shift+Up", "entity.gridUp", nudges<0, -16>},
    KeyTrial{"Shift+Down", "entity.gridDown", nudges<0, 16>},
};

}  // namespace

std::span<const KeyTrial> entityTrials() { return kTrials; }

}  // namespace plumb::editor::ui
