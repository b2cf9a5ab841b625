#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// What a collider is made of and what it collides with: the same for all outlines.
struct ColliderSurface {
    bool isTrigger = false;            ///< reports contacts, stops nothing
    bool oneWay = false;               ///< solid only for what comes from above
    std::uint32_t layers = 1;          ///< bits: what it is
    std::uint32_t mask = 0xffffffffu;  ///< bits: what it collides with
    float friction = -1.0f;            ///< 0 is ice; negative takes the RigidBody's, or else 0.6
    float bounciness = -1.0f;          ///< ratio of the speed that comes back; negative takes the RigidBody's
    float density = 1.0f;              ///< how much of the body's mass it has, beside its other colliders
    float surfaceSpeed = 0.0f;         ///< px/s, as a conveyor belt; above 0 what lies on it goes right
};

template <class T>
void describeSurface(TypeBuilder<T>& type) {
    type.template field<&T::isTrigger>("isTrigger").doc("Reports contacts, stops nothing.");
    type.template field<&T::oneWay>("oneWay").doc("Solid only for what comes from above.");
    type.template field<&T::layers>("layers").layerBits().doc("What it is.");
    type.template field<&T::mask>("mask").layerBits().doc("What it collides with.");
    type.template field<&T::friction>("friction")
        .unit(Unit::Ratio)
        .range(-1.0f, 10.0f)
        .doc("0 is ice; negative takes the RigidBody's, or else 0.6.");
    type.template field<&T::bounciness>("bounciness")
        .unit(Unit::Ratio)
        .range(-1.0f, 1.0f)
        .doc("Part of the speed that comes back; negative takes the RigidBody's.");
    type.template field<&T::density>("density")
        .range(0.0f, 1e6f)
        .doc("How much of the body's mass it has, beside its other colliders.");
    type.template field<&T::surfaceSpeed>("surfaceSpeed")
        .unit(Unit::PixelsPerSecond)
        .doc("Along the surface, as a conveyor belt.");
}

}  // namespace plumb
