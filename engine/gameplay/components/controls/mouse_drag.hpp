#pragma once

#include "reflect/entity_id.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Lets the mouse drag bodies: pulls the RigidBody, Rope, Cloth or Jelly
/// under the mouse while the left button is held. The entity follows the
/// mouse, and its Sprite and children are visible while a body is dragged.
struct MouseDrag {
    float acceleration = 12'000.0f;   ///< px/s^2: maximum acceleration, so that walls stop the dragged body
    std::uint32_t mask = 0xffffffff;  ///< bits: collision layers of bodies that can be dragged
    EntityId held;                    ///< entity that is dragged; may be empty

    static void describe(TypeBuilder<MouseDrag>& type) {
        type.name("MouseDrag")
            .doc(
                "Lets the mouse drag bodies. The entity follows the mouse and is visible while a body is "
                "dragged.");
        type.field<&MouseDrag::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(1.0f, 1e6f)
            .doc("Maximum acceleration of the dragged body, px/s2; walls can stop it.");
        type.field<&MouseDrag::mask>("mask").layerBits().doc(
            "Collision layers of bodies that can be dragged.");
        type.field<&MouseDrag::held>("held").transient();
    }
};

}  // namespace plumb
