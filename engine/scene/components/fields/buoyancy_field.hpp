#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// A fluid: lifts what is in it and slows it down.
struct BuoyancyField : FieldRegion {
    float density = 1.0f;      ///< kg/m^2: what is lighter swims
    Vec2 velocity;             ///< px/s of its current
    float linearDrag = 2.0f;   ///< 1/s
    float angularDrag = 1.0f;  ///< 1/s

    static void describe(TypeBuilder<BuoyancyField>& type) {
        type.name("BuoyancyField").doc("A fluid: lifts what is in it and slows it down.");
        describeRegion(type);
        type.field<&BuoyancyField::density>("density")
            .range(0.0f, 1e6f)
            .doc("kg/m2: what has less mass for its area swims.");
        type.field<&BuoyancyField::velocity>("velocity").unit(Unit::PixelsPerSecond).doc("Of its current.");
        type.field<&BuoyancyField::linearDrag>("linearDrag").range(0.0f, 1000.0f).doc("1/s.");
        type.field<&BuoyancyField::angularDrag>("angularDrag").range(0.0f, 1000.0f).doc("1/s.");
    }
    void apply(physics::FieldDefinition& field, float metres) const {
        field.kind = physics::FieldKind::Buoyancy;
        field.density = density;
        field.velocity = velocity * metres;
        field.linearDrag = linearDrag;
        field.angularDrag = angularDrag;
    }
};

}  // namespace plumb
