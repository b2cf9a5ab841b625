#pragma once

#include <cstdint>

#include "math/color.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A list of choices: the MenuItems of its scene, from the lowest order to the highest. Up and Down move,
/// Confirm takes one, and so does the mouse; Cancel and Pause close an overlay. Sounds: SoundCues step and
/// activate.
struct Menu {
    Color color;  ///< of the items
    Color selectedColor{255, 216, 102, 255};
    EntityId cursor;                  ///< goes to the selected item; may be empty
    Vec2 cursorOffset{-12.0f, 0.0f};  ///< px, from the item
    bool closes = true;               ///< Cancel and Pause take the overlay away
    std::int32_t selected = 0;        ///< place in the list
    std::int32_t pushed = 0;          ///< -1 up, 1 down: the way in which it was pushed one tick ago

    static void describe(TypeBuilder<Menu>& type) {
        type.name("Menu").doc("A list of choices: the MenuItems of its scene.");
        type.field<&Menu::color>("color").doc("Of the items.");
        type.field<&Menu::selectedColor>("selectedColor").doc("Of the one that Confirm takes.");
        type.field<&Menu::cursor>("cursor").doc("Goes to the selected item.");
        type.field<&Menu::cursorOffset>("cursorOffset").unit(Unit::Pixels).doc("From the item.");
        type.field<&Menu::closes>("closes").doc("Cancel and Pause take the overlay away.");
        type.field<&Menu::selected>("selected").transient();
        type.field<&Menu::pushed>("pushed").transient();
    }
};

}  // namespace plumb
