#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

enum class MenuAction : std::uint8_t { Close, GoTo, Restart, Quit, Open };

/// A choice in a Menu; its Label is what is read.
struct MenuItem {
    std::int32_t order = 0;  ///< lowest first
    MenuAction action = MenuAction::Close;
    SceneId scene;  ///< where GoTo leads, what Open lays over

    static void describe(TypeBuilder<MenuItem>& type) {
        type.name("MenuItem").doc("A choice in a Menu; its Label is what is read.");
        type.field<&MenuItem::order>("order").doc("Lowest first.");
        type.field<&MenuItem::action>("action")
            .names({{"close", 0}, {"goTo", 1}, {"restart", 2}, {"quit", 3}, {"open", 4}})
            .doc(
                "Takes the overlay away, goes to a scene, begins the scene below anew, ends the game, "
                "lays a scene over this one.");
        type.field<&MenuItem::scene>("scene").doc("Where goTo leads, what open lays over.");
    }
};

}  // namespace plumb
