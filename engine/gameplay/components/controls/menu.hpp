#pragma once

#include <cstdint>

#include "math/color.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A menu of the MenuItems in its scene, sorted by ascending order. The axis
/// Vertical and the mouse select an item, Confirm and a click activate it;
/// Cancel and Pause close an overlay. An item that loads a slot without a
/// saved game is dim and cannot be selected. Plays the SoundCues `step` and `activate`.
struct Menu {
    Color color;                              ///< color of items that are not selected
    Color selectedColor{255, 216, 102, 255};  ///< color of the selected item
    EntityId cursor;                          ///< entity that is moved to the selected item; may be empty
    Vec2 cursorOffset{-12.0f, 0.0f};          ///< px, from the selected item to the cursor
    bool closes = true;                       ///< Cancel and Pause close the overlay
    std::int32_t selected = 0;                ///< index of the selected item
    std::int32_t pushed = 0;                  ///< direction of the input axis one tick ago: -1 up, 1 down

    static void describe(TypeBuilder<Menu>& type) {
        type.name("Menu").doc("A menu of the MenuItems in its scene.");
        type.field<&Menu::color>("color").doc("Color of items that are not selected.");
        type.field<&Menu::selectedColor>("selectedColor").doc("Color of the selected item.");
        type.field<&Menu::cursor>("cursor").doc("Entity that is moved to the selected item.");
        type.field<&Menu::cursorOffset>("cursorOffset")
            .unit(Unit::Pixels)
            .doc("Vector from the selected item to the cursor, px.");
        type.field<&Menu::closes>("closes").doc("The actions Cancel and Pause close the overlay.");
        type.field<&Menu::selected>("selected").transient();
        type.field<&Menu::pushed>("pushed").transient();
    }
};

}  // namespace plumb
