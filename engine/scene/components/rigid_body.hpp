#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A body that gravity, velocity and collisions move.
struct RigidBody {
    Vec2 velocity;              ///< px/s
    Vec2 acceleration;          ///< px/s^2, added to gravity
    float mass = 1.0f;          ///< kg
    float friction = 0.1f;      ///< 0 is ice
    float bounciness = 0.0f;    ///< ratio of the speed that comes back
    float gravityScale = 1.0f;  ///< ratio; 0 floats
    bool grounded = false;      ///< stands on something since the last collision step

    RigidBody() = default;
    explicit RigidBody(float kilograms) : mass{kilograms} {}

    static void describe(TypeBuilder<RigidBody>& type) {
        type.name("RigidBody").doc("A body that gravity, velocity and collisions move.");
        type.field<&RigidBody::velocity>("velocity").unit(Unit::PixelsPerSecond);
        type.field<&RigidBody::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("Added to gravity.");
        type.field<&RigidBody::mass>("mass").unit(Unit::Kilograms).range(1e-4f, 1e4f);
        type.field<&RigidBody::friction>("friction").unit(Unit::Ratio).range(0.0f, 10.0f).doc("0 is ice.");
        type.field<&RigidBody::bounciness>("bounciness")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Part of the speed that comes back.");
        type.field<&RigidBody::gravityScale>("gravityScale")
            .unit(Unit::Ratio)
            .range(-10.0f, 10.0f)
            .doc("0 floats.");
        type.field<&RigidBody::grounded>("grounded").transient();
    }
};

}  // namespace plumb
