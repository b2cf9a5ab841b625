#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// Another gravity in a region: along a direction, or towards its middle.
struct GravityField : FieldRegion {
    Vec2 acceleration;             ///< px/s^2
    float towardsMiddle = 0.0f;    ///< px/s^2; negative pushes away from it
    bool replacesGravity = false;  ///< the scene's gravity does not act in it

    static void describe(TypeBuilder<GravityField>& type) {
        type.name("GravityField").doc("Another gravity in a region.");
        describeRegion(type);
        type.field<&GravityField::acceleration>("acceleration").unit(Unit::PixelsPerSecondSquared);
        type.field<&GravityField::towardsMiddle>("towardsMiddle")
            .unit(Unit::PixelsPerSecondSquared)
            .doc("Negative pushes away from it.");
        type.field<&GravityField::replacesGravity>("replacesGravity")
            .doc("The scene's gravity does not act in it.");
    }
    void apply(physics::FieldDefinition& field, float metres) const {
        field.kind = physics::FieldKind::AreaGravity;
        field.acceleration = acceleration * metres;
        field.strength = towardsMiddle * metres;
        field.replacesGravity = replacesGravity;
    }
};

}  // namespace plumb
