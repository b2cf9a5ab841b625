#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that teleports every RigidBody that enters it.
struct Portal {
    Vec2 shift;                ///< px, displacement of the teleported body
    bool keepVelocity = true;  ///< false: the body is at rest after teleporting

    static void describe(TypeBuilder<Portal>& type) {
        type.name("Portal").doc("A trigger that teleports every RigidBody that enters it.");
        type.field<&Portal::shift>("shift")
            .unit(Unit::Pixels)
            .doc("Displacement of the teleported body, px.");
        type.field<&Portal::keepVelocity>("keepVelocity")
            .doc("The body keeps its velocity; off: it is at rest after teleporting.");
    }
};

}  // namespace plumb
