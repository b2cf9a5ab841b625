#pragma once

#include "reflect/entity_id.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A hand that follows the mouse: it pulls the RigidBody, Rope, Cloth or Jelly it was pressed on. What else
/// the entity has, e.g. a Sprite, is seen while it holds something.
struct MouseDrag {
    float acceleration = 12'000.0f;   ///< px/s^2: the most, so that nothing is dragged through walls
    std::uint32_t mask = 0xffffffff;  ///< bits: what it can take
    EntityId held;                    ///< empty while nothing is dragged

    static void describe(TypeBuilder<MouseDrag>& type) {
        type.name("MouseDrag").doc("A hand that follows the mouse and pulls bodies; seen while it does.");
        type.field<&MouseDrag::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(1.0f, 1e6f)
            .doc("The most, so that nothing is dragged through walls.");
        type.field<&MouseDrag::mask>("mask").layerBits().doc("What it can take.");
        type.field<&MouseDrag::held>("held").transient();
    }
};

}  // namespace plumb
