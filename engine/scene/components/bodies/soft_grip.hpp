#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Pulls one particle of the entity's rope, cloth or jelly towards a point, like a mouse that drags it.
/// Nearby particles are pulled too, less with distance.
struct SoftGrip {
    int particle = 0;     ///< index of the held particle
    Vec2 anchor;          ///< px from the particle to the point that is pulled
    Vec2 target;          ///< px in the world: the point that the anchor is pulled to
    float reach = 48.0f;  ///< px: distance from the particle at which the pull has fallen to a quarter
    float acceleration = 12'000.0f;  ///< px/s^2: maximum acceleration of the particle

    static void describe(TypeBuilder<SoftGrip>& type) {
        type.name("SoftGrip")
            .doc("Pulls a particle of the entity's rope, cloth or jelly to a point in the world.");
        type.field<&SoftGrip::particle>("particle").range(0.0f, 1e4f).doc("Index of the held particle.");
        type.field<&SoftGrip::anchor>("anchor")
            .unit(Unit::Pixels)
            .doc("Vector from the particle to the point that is pulled, px.");
        type.field<&SoftGrip::target>("target")
            .unit(Unit::Pixels)
            .doc("Point in the world that the anchor is pulled to, px.");
        type.field<&SoftGrip::reach>("reach")
            .unit(Unit::Pixels)
            .range(1.0f, 1e5f)
            .doc("Distance from the particle at which the pull has fallen to a quarter, px.");
        type.field<&SoftGrip::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 1e6f)
            .doc("Maximum acceleration of the held particle, px/s2.");
    }
};

}  // namespace plumb
