#pragma once

#include "core/text_store.hpp"
#include "gameplay/components/controls/menu_item.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// An action that changes the scene at once: back to a menu, begin anew, pause, quit.
struct SceneKey {
    TextId action;  ///< one of project.json
    MenuAction does = MenuAction::GoTo;
    SceneId scene;  ///< where GoTo leads, what Open lays over

    static void describe(TypeBuilder<SceneKey>& type) {
        type.name("SceneKey").doc("An action that changes the scene at once.");
        type.field<&SceneKey::action>("action").doc("One of project.json.");
        type.field<&SceneKey::does>("does")
            .names({{"close", 0}, {"goTo", 1}, {"restart", 2}, {"quit", 3}, {"open", 4}})
            .doc(
                "Takes the overlay away, goes to a scene, begins this one anew, ends the game, "
                "lays a scene over this one.");
        type.field<&SceneKey::scene>("scene").doc("Where goTo leads, what open lays over.");
    }
};

}  // namespace plumb
