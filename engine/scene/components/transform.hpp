#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Position, rotation and scale of an entity, relative to its parent, or to the world if it has none.
/// The `previous` fields are the pose one tick ago; drawing interpolates between the two.
struct Transform {
    Vec2 position;                   ///< px, y down
    float rotation = 0.0f;           ///< rad, clockwise on screen
    Vec2 scale{1.0f, 1.0f};          ///< ratio
    Vec2 previousPosition;           ///< px, one tick ago
    float previousRotation = 0.0f;   ///< rad, one tick ago
    Vec2 previousScale{1.0f, 1.0f};  ///< ratio, one tick ago

    Transform() = default;
    Transform(float x, float y) : Transform{Vec2{x, y}} {}
    explicit Transform(Vec2 at, float angle = 0.0f, Vec2 size = {1.0f, 1.0f})
        : position{at},
          rotation{angle},
          scale{size},
          previousPosition{at},
          previousRotation{angle},
          previousScale{size} {}

    static void describe(TypeBuilder<Transform>& type) {
        type.name("Transform")
            .doc("Position, rotation and scale, relative to the parent, or to the world without one.");
        type.field<&Transform::position>("position")
            .unit(Unit::Pixels)
            .doc("Position of the entity's origin, px; y points down.");
        type.field<&Transform::rotation>("rotation")
            .unit(Unit::Radians)
            .doc("Rotation, degrees, clockwise on screen.");
        type.field<&Transform::scale>("scale")
            .unit(Unit::Ratio)
            .doc("Scale as a ratio; 1 is the natural size.");
        type.field<&Transform::previousPosition>("previousPosition").unit(Unit::Pixels).transient();
        type.field<&Transform::previousRotation>("previousRotation").unit(Unit::Radians).transient();
        type.field<&Transform::previousScale>("previousScale").unit(Unit::Ratio).transient();
    }
};

/// Sets the position without interpolating the motion from the old one when drawing.
inline void teleport(Transform& transform, Vec2 position) {
    transform.position = position;
    transform.previousPosition = position;
}

}  // namespace plumb
