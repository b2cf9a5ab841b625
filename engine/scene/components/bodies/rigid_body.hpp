#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A body that gravity, velocity and collisions move and turn.
struct RigidBody {
    Vec2 velocity;                 ///< px/s, of its centre of mass
    Vec2 acceleration;             ///< px/s^2, added to gravity
    float mass = 1.0f;             ///< kg
    float friction = 0.1f;         ///< 0 is ice
    float bounciness = 0.0f;       ///< ratio of the speed that comes back
    float gravityScale = 1.0f;     ///< ratio; 0 floats
    bool grounded = false;         ///< stands on something since the last collision step
    float angularVelocity = 0.0f;  ///< rad/s, clockwise on screen
    bool fixedRotation = false;    ///< never turns
    float linearDrag = 0.0f;       ///< 1/s, part of the speed lost in a second
    float angularDrag = 0.0f;      ///< 1/s, the same of turning
    bool bullet = false;           ///< never passes through what moves, however fast it is
    bool canSleep = true;          ///< may stop costing time while it rests
    bool lockX = false;            ///< never moves along x
    bool lockY = false;            ///< never moves along y
    int quality = -1;              ///< 2^quality substeps for it and what it touches; -1 is the scene's

    RigidBody() = default;
    explicit RigidBody(float kilograms) : mass{kilograms} {}

    static void describe(TypeBuilder<RigidBody>& type) {
        type.name("RigidBody").doc("A body that gravity, velocity and collisions move and turn.");
        type.field<&RigidBody::velocity>("velocity").unit(Unit::PixelsPerSecond);
        type.field<&RigidBody::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("Added to gravity.");
        type.field<&RigidBody::mass>("mass").unit(Unit::Kilograms).range(1e-4f, 1e6f);
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
        type.field<&RigidBody::angularVelocity>("angularVelocity")
            .unit(Unit::RadiansPerSecond)
            .doc("Clockwise on screen.");
        type.field<&RigidBody::fixedRotation>("fixedRotation").doc("Never turns.");
        type.field<&RigidBody::linearDrag>("linearDrag")
            .range(0.0f, 1000.0f)
            .doc("1/s: part of the speed lost in a second.");
        type.field<&RigidBody::angularDrag>("angularDrag")
            .range(0.0f, 1000.0f)
            .doc("1/s: the same of turning.");
        type.field<&RigidBody::bullet>("bullet").doc("Never passes through what moves, however fast it is.");
        type.field<&RigidBody::canSleep>("canSleep").doc("May stop costing time while it rests.");
        type.field<&RigidBody::lockX>("lockX").doc("Never moves along x.");
        type.field<&RigidBody::lockY>("lockY").doc("Never moves along y.");
        type.field<&RigidBody::quality>("quality")
            .range(-1.0f, 6.0f)
            .doc("2^quality substeps for it and what it touches; -1 is the scene's.");
    }
};

}  // namespace plumb
