#include <array>
#include <cmath>

#include "core/text.hpp"
#include "editor/ui/fields/field_row.hpp"
#include "scene/components/colliders/polygon_collider.hpp"
#include "scene/components/joints/revolute_joint.hpp"
#include "scene/components/scene_physics.hpp"
#include "tests/editor/support/inspector_fixture.hpp"

namespace plumb::editor::ui {
namespace {

// ---- values selected from lists, and whole components

TEST_F(Inspector, anEntityIsChosenFromASearchedListAimedAtInTheSceneOrDraggedFromTheTree) {
    select({"camera"});
    const auto follows = [&] { return workspace.document.idOf(of<Camera>("camera").follow); };
    EXPECT_EQ(valueOf("Inspector/Camera/follow"), "player");
    hands.click("Inspector/Camera/follow");
    hands.rest(3);
    hands.type("cra");
    EXPECT_EQ(widget("Inspector/Camera/follow/sign"), nullptr);
    hands.key(Key::Escape);
    EXPECT_EQ(widget("Inspector/Camera/follow/crate"), nullptr) << "Esc leaves the list";
    hands.click("Inspector/Camera/follow");
    hands.rest(3);
    hands.click("Inspector/Camera/follow/crate");
    EXPECT_EQ(follows(), named("crate"));
    hands.rest(2);

    const Vec2 sign = window.widgets().find("Viewport")->box.min + workspace.view.toScreenPoint({104, 24});
    hands.drag(hands.middleOf("Inspector/Camera/follow/aim"), sign);
    EXPECT_EQ(follows(), named("sign"));
    hands.drag(hands.middleOf("Inspector/Camera/follow/aim"), hands.middleOf("Tab/Console"));
    EXPECT_EQ(follows(), named("sign")) << "beside the scene it does nothing";

    hands.drag(hands.middleOf("Scene/lamp"), hands.middleOf("Inspector/Camera/follow"));
    EXPECT_EQ(follows(), named("lamp"));
    EXPECT_EQ(workspace.undo.size(), 3u);
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("camera")});

    hands.click("Inspector/Camera/follow/go");
    EXPECT_EQ(workspace.document.selection.all(), std::vector{named("lamp")});
    EXPECT_EQ(workspace.undo.size(), 3u);
}

TEST_F(Inspector, aFileIsChosenFromASearchedListOrDroppedFromTheAssets) {
    for (const char* path : {"assets/tree.png", "assets/stone.png", "assets/hit.wav"}) putFile(path, "none");
    give("crate", Sprite{});
    give("sign", Sprite{});
    select({"crate", "sign"});
    hands.click("Inspector/Sprite/texture");
    hands.rest(3);
    EXPECT_NE(widget("Inspector/Sprite/texture/assets/tree.png"), nullptr);
    EXPECT_EQ(widget("Inspector/Sprite/texture/assets/hit.wav"), nullptr) << "no picture";
    hands.type("ston");
    EXPECT_EQ(widget("Inspector/Sprite/texture/assets/tree.png"), nullptr);
    hands.key(Key::Enter);
    hands.rest(2);
    EXPECT_EQ(widget("Inspector/Sprite/texture/search"), nullptr) << "Enter took the first";
    const auto textureOf = [&](const char* name) {
        return std::string{workspace.document.world.texts().find(of<Sprite>(name).texture.path)};
    };
    EXPECT_EQ(textureOf("crate"), "assets/stone.png");
    EXPECT_EQ(textureOf("sign"), "assets/stone.png");
    EXPECT_EQ(workspace.undo.size(), 1u);

    hands.click("Tab/Assets");
    hands.rest(2);
    hands.click("Assets/folder/assets");
    hands.rest(2);
    hands.drag(hands.middleOf("Assets/assets/hit.wav"), hands.middleOf("Inspector/Sprite/texture"));
    EXPECT_EQ(workspace.undo.size(), 1u);
    EXPECT_NE(workspace.notice.find("is not a file of the kind"), std::string::npos) << workspace.notice;
    hands.drag(hands.middleOf("Assets/assets/tree.png"), hands.middleOf("Inspector/Sprite/texture"));
    EXPECT_EQ(textureOf("crate"), "assets/tree.png");
    EXPECT_EQ(workspace.undo.size(), 2u);
}

// ---- components

TEST_F(Inspector, aComponentIsFoundByNameAndAddedToTheEntitiesThatLackIt) {
    select({"player", "sign"});
    hands.click("Inspector/add");
    hands.rest(3);
    EXPECT_NE(widget("Inspector/add/Sprite"), nullptr);
    EXPECT_EQ(widget("Inspector/add/Transform"), nullptr) << "all have it";
    hands.type("rigidb");
    EXPECT_EQ(widget("Inspector/add/Sprite"), nullptr);
    hands.key(Key::Enter);
    hands.rest();
    EXPECT_TRUE(workspace.document.world.has<RigidBody>(workspace.document.find(named("sign"))));
    EXPECT_EQ(workspace.undo.size(), 1u);
    EXPECT_NE(widget("Inspector/RigidBody"), nullptr) << "now both have it";
    menu("Inspector/RigidBody", "Inspector/RigidBody/remove");
    EXPECT_FALSE(workspace.document.world.has<RigidBody>(workspace.document.find(named("player"))));
    workspace.undo.jumpTo(0);
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Inspector, aComponentIsCopiedAsTextAndPastedOntoSeveral) {
    select({"player"});
    hands.enterNumber("Inspector/RigidBody/mass", "4");
    menu("Inspector/RigidBody", "Inspector/RigidBody/copy");
    EXPECT_TRUE(startsWith(workspace.clipboard, "{\n  \"plumbComponent\": \"RigidBody\""))
        << workspace.clipboard;
    const std::string before = workspace.text();
    select({"crate", "sign"});
    menu("Inspector/Transform", "Inspector/Transform/paste");
    EXPECT_EQ(of<RigidBody>("crate").mass, 4.0f);
    EXPECT_EQ(of<RigidBody>("sign").mass, 4.0f);
    EXPECT_EQ(workspace.undo.size(), 2u);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
    workspace.clipboard.replace(workspace.clipboard.find("\"mass\": 4"), 9, "\"mass\": \"x\"");
    menu("Inspector/Transform", "Inspector/Transform/paste");
    EXPECT_EQ(workspace.text(), before);
    EXPECT_NE(workspace.notice.find("mass"), std::string::npos) << workspace.notice;
}

TEST_F(Inspector, aComponentIsResetToItsDefaults) {
    select({"player", "crate"});
    menu("Inspector/BoxCollider", "Inspector/BoxCollider/reset");
    EXPECT_EQ(of<BoxCollider>("player").width, BoxCollider{}.width);
    EXPECT_EQ(of<BoxCollider>("crate").height, BoxCollider{}.height);
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(Inspector, foldedComponentsStayFoldedForTheNextEntity) {
    select({"player"});
    hands.click("Inspector/Transform");
    EXPECT_EQ(widget(kX), nullptr);
    select({"crate"});
    EXPECT_EQ(widget(kX), nullptr);
    EXPECT_EQ(workspace.undo.total(), 0u);
}

}  // namespace
}  // namespace plumb::editor::ui
