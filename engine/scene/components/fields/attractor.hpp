#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// Pulls towards the entity, as a planet or a magnet.
struct Attractor : FieldRegion {
    float acceleration = 500.0f;  ///< px/s^2 at `distance`; negative pushes away
    float distance = 200.0f;      ///< px at which the pull is `acceleration`
    bool linear = false;     ///< grows with the distance, as a spring, instead of falling with its square
    float softness = 16.0f;  ///< px: nearer than this the pull grows no more

    static void describe(TypeBuilder<Attractor>& type) {
        type.name("Attractor").doc("Pulls towards the entity, as a planet or a magnet.");
        describeRegion(type);
        type.field<&Attractor::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("At the distance; negative pushes away.");
        type.field<&Attractor::distance>("distance").unit(Unit::Pixels).range(1e-3f, 1e6f);
        type.field<&Attractor::linear>("linear").doc("Grows with the distance, as a spring.");
        type.field<&Attractor::softness>("softness")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Nearer than this the pull grows no more.");
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
