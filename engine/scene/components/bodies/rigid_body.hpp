#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A dynamic body: moved and rotated by gravity, forces and collisions.
struct RigidBody {
    Vec2 velocity;                 ///< px/s, of the center of mass
    Vec2 acceleration;             ///< px/s^2, added to gravity
    float mass = 1.0f;             ///< kg
    float friction = 0.1f;         ///< friction coefficient; 0 is frictionless
    float bounciness = 0.0f;       ///< restitution: ratio of the impact speed kept after a bounce
    float gravityScale = 1.0f;     ///< ratio to the scene's gravity; 0: no gravity
    bool grounded = false;         ///< rested on another body at the end of the last physics step
    float angularVelocity = 0.0f;  ///< rad/s, clockwise on screen
    bool fixedRotation = false;    ///< never rotates
    float linearDrag = 0.0f;       ///< 1/s: decay rate of the velocity
    float angularDrag = 0.0f;      ///< 1/s: decay rate of the angular velocity
    bool bullet = false;           ///< continuous collision detection against moving bodies too
    bool canSleep = true;          ///< may fall asleep while at rest, to save time
    bool lockX = false;            ///< never moves along x
    bool lockY = false;            ///< never moves along y
    int quality = -1;  ///< 2^quality substeps per tick for it and bodies it touches; -1: the scene's quality

    RigidBody() = default;
    explicit RigidBody(float kilograms) : mass{kilograms} {}

    static void describe(TypeBuilder<RigidBody>& type) {
        type.name("RigidBody").doc("A dynamic body: moved and rotated by gravity, forces and collisions.");
        type.field<&RigidBody::velocity>("velocity").unit(Unit::PixelsPerSecond);
        type.field<&RigidBody::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("Constant acceleration added to gravity, px/s2.");
        type.field<&RigidBody::mass>("mass").unit(Unit::Kilograms).range(1e-4f, 1e6f);
        type.field<&RigidBody::friction>("friction")
            .unit(Unit::Ratio)
            .range(0.0f, 10.0f)
            .doc("Friction coefficient; 0 is frictionless.");
        type.field<&RigidBody::bounciness>("bounciness")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Restitution: ratio of the impact speed kept after a bounce.");
        type.field<&RigidBody::gravityScale>("gravityScale")
            .unit(Unit::Ratio)
            .range(-10.0f, 10.0f)
            .doc("Ratio to the scene's gravity; 0: no gravity.");
        type.field<&RigidBody::grounded>("grounded").transient();
        type.field<&RigidBody::angularVelocity>("angularVelocity")
            .unit(Unit::RadiansPerSecond)
            .doc("Angular velocity, degrees/s, clockwise on screen.");
        type.field<&RigidBody::fixedRotation>("fixedRotation").doc("The body never rotates.");
        type.field<&RigidBody::linearDrag>("linearDrag")
            .range(0.0f, 1000.0f)
            .doc("Decay rate of the velocity, 1/s.");
        type.field<&RigidBody::angularDrag>("angularDrag")
            .range(0.0f, 1000.0f)
            .doc("Decay rate of the angular velocity, 1/s.");
        type.field<&RigidBody::bullet>("bullet").doc(
            "Continuous collision detection against moving bodies too, for very fast bodies.");
        type.field<&RigidBody::canSleep>("canSleep")
            .doc("The body may fall asleep while at rest, to save time.");
        type.field<&RigidBody::lockX>("lockX").doc("The body never moves along x.");
        type.field<&RigidBody::lockY>("lockY").doc("The body never moves along y.");
        type.field<&RigidBody::quality>("quality")
            .range(-1.0f, 6.0f)
            .doc(
                "Quality: 2^quality substeps per tick for this body and the bodies it touches; -1: the "
                "scene's quality.");
    }
};

}  // namespace plumb
