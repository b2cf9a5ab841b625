#pragma once

#include "core/text_store.hpp"
#include "gameplay/components/controls/menu_item.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// An input action that changes the scene: back to a menu, restart, pause, quit.
struct SceneKey {
    TextId action;                       ///< name of the input action (project.json)
    MenuAction does = MenuAction::GoTo;  ///< scene change that the action performs
    SceneId scene;                       ///< scene for GoTo and Open

    static void describe(TypeBuilder<SceneKey>& type) {
        type.name("SceneKey").doc("An input action that changes the scene.");
        type.field<&SceneKey::action>("action").doc("Input action, by its name in project.json.");
        withActionNames(type.field<&SceneKey::does>("does"))
            .doc(
                "Scene change: close the overlay, change to a scene, restart the scene, quit the game, or "
                "open a scene as an overlay, save or load the game, or open the options of the player.");
        type.field<&SceneKey::scene>("scene").doc("Scene for goTo and open.");
    }
};

}  // namespace plumb
