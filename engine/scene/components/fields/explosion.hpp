#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// Pushes bodies away from the entity once, in the next tick; the component is then removed.
struct Explosion {
    float radius = 128.0f;               ///< px, at which the impulse has fallen to 0
    float impulse = 20.0f;               ///< kg px/s per px of the body's width, at the center
    std::uint32_t layers = 0xffffffffu;  ///< bits: collision layers that it acts on

    static void describe(TypeBuilder<Explosion>& type) {
        type.name("Explosion")
            .doc("Pushes bodies away from the entity once, in the next tick; the component is then removed.");
        type.field<&Explosion::radius>("radius")
            .unit(Unit::Pixels)
            .range(0.0f, 1e6f)
            .doc("Radius at which the impulse has fallen to 0, px.");
        type.field<&Explosion::impulse>("impulse")
            .range(-1e9f, 1e9f)
            .doc("Impulse at the center, kg px/s per px of the body's width.");
        type.field<&Explosion::layers>("layers").layerBits().doc(
            "Collision layers that the explosion acts on.");
    }
    void apply(physics::FieldDefinition& field, float metres) const {
        field.kind = physics::FieldKind::Explosion;
        field.radius = radius * metres;
        field.strength = impulse;
    }
};

}  // namespace plumb
