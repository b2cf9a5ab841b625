#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// Pushes what is around the entity away, once, in the next tick; then the component is gone.
struct Explosion {
    float radius = 128.0f;               ///< px
    float impulse = 20.0f;               ///< kg px/s for each px of width that faces it, at its middle
    std::uint32_t layers = 0xffffffffu;  ///< bits: acts on colliders of these layers

    static void describe(TypeBuilder<Explosion>& type) {
        type.name("Explosion").doc("Pushes what is around it away, once, in the next tick.");
        type.field<&Explosion::radius>("radius").unit(Unit::Pixels).range(0.0f, 1e6f);
        type.field<&Explosion::impulse>("impulse")
            .range(-1e9f, 1e9f)
            .doc("kg px/s for each px of width that faces it, at its middle.");
        type.field<&Explosion::layers>("layers").layerBits().doc("Acts on colliders of these layers.");
    }
    void apply(physics::FieldDefinition& field, float metres) const {
        field.kind = physics::FieldKind::Explosion;
        field.radius = radius * metres;
        field.strength = impulse;
    }
};

}  // namespace plumb
