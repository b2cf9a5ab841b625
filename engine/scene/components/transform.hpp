#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Where an entity is: in the world, or in its parent when it has one.
/// The `previous` fields are the pose one tick ago; drawing goes from there to here.
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
        type.name("Transform").doc("Where the entity is: in the world, or in its parent when it has one.");
        type.field<&Transform::position>("position")
            .unit(Unit::Pixels)
            .doc("The entity's origin; y points down.");
        type.field<&Transform::rotation>("rotation").unit(Unit::Radians).doc("Clockwise on screen.");
        type.field<&Transform::scale>("scale").unit(Unit::Ratio).doc("1 is the natural size.");
        type.field<&Transform::previousPosition>("previousPosition").unit(Unit::Pixels).transient();
        type.field<&Transform::previousRotation>("previousRotation").unit(Unit::Radians).transient();
        type.field<&Transform::previousScale>("previousScale").unit(Unit::Ratio).transient();
    }
};

/// Puts a transform somewhere without drawing the way there.
inline void teleport(Transform& transform, Vec2 position) {
    transform.position = position;
    transform.previousPosition = position;
}

}  // namespace plumb
