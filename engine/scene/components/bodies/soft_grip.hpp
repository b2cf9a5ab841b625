#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Pulls the entity's rope, cloth or jelly to a place in the world, as a hand or a mouse would: a particle of
/// it and, less, what is around that.
struct SoftGrip {
    int particle = 0;
    Vec2 anchor;                     ///< px from the particle to what is pulled
    Vec2 target;                     ///< px in the world: where that is wanted
    float reach = 48.0f;             ///< px around the particle at which the pull is a quarter
    float acceleration = 12'000.0f;  ///< px/s^2: the most

    static void describe(TypeBuilder<SoftGrip>& type) {
        type.name("SoftGrip").doc("Pulls the entity's rope, cloth or jelly to a place in the world.");
        type.field<&SoftGrip::particle>("particle").range(0.0f, 1e4f).doc("Which one it holds.");
        type.field<&SoftGrip::anchor>("anchor")
            .unit(Unit::Pixels)
            .doc("From the particle to what is pulled.");
        type.field<&SoftGrip::target>("target").unit(Unit::Pixels).doc("In the world.");
        type.field<&SoftGrip::reach>("reach")
            .unit(Unit::Pixels)
            .range(1.0f, 1e5f)
            .doc("From the particle to where the pull is a quarter.");
        type.field<&SoftGrip::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 1e6f)
            .doc("The most.");
    }
};

}  // namespace plumb
