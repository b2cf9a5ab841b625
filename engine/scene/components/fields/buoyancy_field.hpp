#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// A region of fluid: bodies in it are lifted by buoyancy and slowed down.
struct BuoyancyField : FieldRegion {
    float density = 1.0f;      ///< kg/m^2, of the fluid; bodies with less mass per area float
    Vec2 velocity;             ///< px/s, current of the fluid
    float linearDrag = 2.0f;   ///< 1/s, decay rate of the velocity relative to the current
    float angularDrag = 1.0f;  ///< 1/s, decay rate of the angular velocity

    static void describe(TypeBuilder<BuoyancyField>& type) {
        type.name("BuoyancyField")
            .doc("A region of fluid: bodies in it are lifted by buoyancy and slowed down.");
        describeRegion(type);
        type.field<&BuoyancyField::density>("density")
            .range(0.0f, 1e6f)
            .doc("Density of the fluid, kg/m2; bodies with less mass per area float.");
        type.field<&BuoyancyField::velocity>("velocity")
            .unit(Unit::PixelsPerSecond)
            .doc("Velocity of the fluid's current, px/s.");
        type.field<&BuoyancyField::linearDrag>("linearDrag")
            .range(0.0f, 1000.0f)
            .doc("Decay rate of the velocity relative to the current, 1/s.");
        type.field<&BuoyancyField::angularDrag>("angularDrag")
            .range(0.0f, 1000.0f)
            .doc("Decay rate of the angular velocity, 1/s.");
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
