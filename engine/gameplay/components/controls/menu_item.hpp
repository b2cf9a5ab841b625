#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// What an item of a Menu or a SceneKey does: it closes the overlay, changes to a scene, restarts the scene
/// below, quits the game, opens a scene as an overlay, saves or loads the game, or opens the options.
enum class MenuAction : std::uint8_t { Close, GoTo, Restart, Quit, Open, Save, Load, Options };

inline FieldBuilder withActionNames(FieldBuilder field) {
    return field.names({{"close", 0},
                        {"goTo", 1},
                        {"restart", 2},
                        {"quit", 3},
                        {"open", 4},
                        {"save", 5},
                        {"load", 6},
                        {"options", 7}});
}

/// An item of a Menu; its text is the entity's Label.
struct MenuItem {
    std::int32_t order = 0;  ///< position in the menu: ascending order
    MenuAction action = MenuAction::Close;
    SceneId scene;  ///< scene for GoTo and Open

    static void describe(TypeBuilder<MenuItem>& type) {
        type.name("MenuItem").doc("An item of a Menu; its text is the entity's Label.");
        type.field<&MenuItem::order>("order").doc(
            "Position in the menu: items are sorted by ascending order.");
        withActionNames(type.field<&MenuItem::action>("action"))
            .doc(
                "Action of the item: close the overlay, change to a scene, restart the scene below, quit the "
                "game, open a scene as an overlay, save or load the game, or open the options of the "
                "player.");
        type.field<&MenuItem::scene>("scene").doc("Scene for the actions goTo and open.");
    }
};

}  // namespace plumb
