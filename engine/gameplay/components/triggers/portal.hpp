#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that takes the RigidBodies that enter it elsewhere.
struct Portal {
    Vec2 shift;                ///< px, from where they are to where they go
    bool keepVelocity = true;  ///< else they begin there at rest

    static void describe(TypeBuilder<Portal>& type) {
        type.name("Portal").doc("A trigger that takes the bodies that enter it elsewhere.");
        type.field<&Portal::shift>("shift").unit(Unit::Pixels).doc("From where they are to where they go.");
        type.field<&Portal::keepVelocity>("keepVelocity").doc("Else they begin there at rest.");
    }
};

}  // namespace plumb
