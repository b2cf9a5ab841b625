#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Lets the player push a RigidBody about with the axes Horizontal and Vertical, and jump from what it stands
/// on. It is a force and nothing more: friction, mass and what lies in the way have their say.
struct PushControl {
    float acceleration = 900.0f;  ///< px/s^2, on the ground and in the air
    float maxSpeed = 260.0f;      ///< px/s to each side, after which it pushes no more
    float jumpSpeed = 420.0f;     ///< px/s upwards; 0 cannot jump
    bool flies = false;           ///< pushes up and down too

    static void describe(TypeBuilder<PushControl>& type) {
        type.name("PushControl").doc("Lets the player push a RigidBody about, and jump.");
        type.field<&PushControl::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 1e5f);
        type.field<&PushControl::maxSpeed>("maxSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 1e5f)
            .doc("To each side, after which it pushes no more.");
        type.field<&PushControl::jumpSpeed>("jumpSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 1e5f)
            .doc("Upwards; 0 cannot jump.");
        type.field<&PushControl::flies>("flies").doc("Pushes up and down too.");
    }
};

}  // namespace plumb
