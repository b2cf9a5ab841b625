#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// A region with its own gravity: in a fixed direction, or towards the region's center.
struct GravityField : FieldRegion {
    Vec2 acceleration;             ///< px/s^2, in a fixed direction
    float towardsMiddle = 0.0f;    ///< px/s^2, towards the center; negative pushes away from it
    bool replacesGravity = false;  ///< the scene's gravity does not act in the region

    static void describe(TypeBuilder<GravityField>& type) {
        type.name("GravityField").doc("A region with its own gravity.");
        describeRegion(type);
        type.field<&GravityField::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("Acceleration of bodies in a fixed direction, px/s2.");
        type.field<&GravityField::towardsMiddle>("towardsMiddle")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("Acceleration towards the region's center, px/s2; negative pushes away from it.");
        type.field<&GravityField::replacesGravity>("replacesGravity")
            .doc("The scene's gravity does not act in the region.");
    }
    void apply(physics::FieldDefinition& field, float metres) const {
        field.kind = physics::FieldKind::AreaGravity;
        field.acceleration = acceleration * metres;
        field.strength = towardsMiddle * metres;
        field.replacesGravity = replacesGravity;
    }
};

}  // namespace plumb
