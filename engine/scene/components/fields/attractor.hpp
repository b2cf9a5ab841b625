#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// Pulls bodies towards the entity, like a planet or a magnet.
struct Attractor : FieldRegion {
    float acceleration = 500.0f;  ///< px/s^2, acceleration at `distance`; negative pushes away
    float distance = 200.0f;      ///< px: distance at which the pull is `acceleration`
    bool linear = false;          ///< pull proportional to the distance instead of falling with its square
    float softness = 16.0f;       ///< px: softening length; limits the pull near the center

    static void describe(TypeBuilder<Attractor>& type) {
        type.name("Attractor").doc("Pulls bodies towards the entity, like a planet or a magnet.");
        describeRegion(type);
        type.field<&Attractor::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("Acceleration of bodies at `distance`, px/s2; negative pushes away.");
        type.field<&Attractor::distance>("distance")
            .unit(Unit::Pixels)
            .range(1e-3f, 1e6f)
            .doc("Distance at which the pull is `acceleration`, px.");
        type.field<&Attractor::linear>("linear").doc(
            "Pull proportional to the distance, like a spring; off: it falls with the square of the "
            "distance.");
        type.field<&Attractor::softness>("softness")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Softening length, px: limits the pull near the center.");
    }
    void apply(physics::FieldDefinition& field, float metres) const {
        const float far = distance * metres;
        field.kind = physics::FieldKind::Attractor;
        field.linear = linear;
        field.strength = linear ? acceleration / distance : acceleration * metres * far * far;
        field.length = softness * metres;
    }
};

}  // namespace plumb
