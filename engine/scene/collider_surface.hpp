#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Material and collision filter of a collider; the base of all collider components.
struct ColliderSurface {
    bool isTrigger = false;            ///< reports overlaps and does not collide
    bool oneWay = false;               ///< solid only for bodies that come from above
    std::uint32_t layers = 1;          ///< bits: collision layers of the collider
    std::uint32_t mask = 0xffffffffu;  ///< bits: layers that the collider collides with
    float friction = -1.0f;     ///< friction coefficient; negative: that of the RigidBody, or 0.6 without one
    float bounciness = -1.0f;   ///< restitution, 0..1; negative: that of the RigidBody, or 0 without one
    float density = 1.0f;       ///< relative density: distributes the body's mass over its colliders
    float surfaceSpeed = 0.0f;  ///< px/s, conveyor speed; above 0 moves bodies on top to the right
};

template <class T>
void describeSurface(TypeBuilder<T>& type) {
    type.template field<&T::isTrigger>("isTrigger").doc("Trigger: reports overlaps and does not collide.");
    type.template field<&T::oneWay>("oneWay").doc("Solid only for bodies that come from above.");
    type.template field<&T::layers>("layers").layerBits().doc("Collision layers of this collider.");
    type.template field<&T::mask>("mask").layerBits().doc(
        "Collision layers that this collider collides with.");
    type.template field<&T::friction>("friction")
        .unit(Unit::Ratio)
        .range(-1.0f, 10.0f)
        .doc(
            "Friction coefficient; 0 is frictionless. Negative: the RigidBody's friction, or 0.6 without a "
            "RigidBody.");
    type.template field<&T::bounciness>("bounciness")
        .unit(Unit::Ratio)
        .range(-1.0f, 1.0f)
        .doc(
            "Restitution: ratio of the impact speed kept after a bounce. Negative: the RigidBody's "
            "bounciness, or 0 without a RigidBody.");
    type.template field<&T::density>("density")
        .range(0.0f, 1e6f)
        .doc("Relative density; distributes the body's mass over its colliders.");
    type.template field<&T::surfaceSpeed>("surfaceSpeed")
        .unit(Unit::PixelsPerSecond)
        .doc("Conveyor speed along the surface, px/s; above 0 moves bodies on top to the right.");
}

}  // namespace plumb
