#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// A region of moving air, with gusts. It accelerates light bodies with a large width most.
struct WindField : FieldRegion {
    Vec2 velocity{200.0f, 0.0f};  ///< px/s, mean velocity of the air
    float density = 1.0f;         ///< kg/m^2: half the air's density times the drag coefficient
    float gust = 0.0f;            ///< px/s: maximum deviation from the mean speed
    int gustTicks = 30;           ///< ticks between gusts

    static void describe(TypeBuilder<WindField>& type) {
        type.name("WindField").doc("A region of moving air, with gusts.");
        describeRegion(type);
        type.field<&WindField::velocity>("velocity")
            .unit(Unit::PixelsPerSecond)
            .doc("Mean velocity of the air, px/s.");
        type.field<&WindField::density>("density")
            .range(0.0f, 1e6f)
            .doc("Strength of the wind, kg/m2: half the air's density times the drag coefficient.");
        type.field<&WindField::gust>("gust")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 1e5f)
            .doc("Maximum deviation from the mean speed in gusts, px/s.");
        type.field<&WindField::gustTicks>("gustTicks")
            .unit(Unit::Ticks)
            .range(1.0f, 1e6f)
            .doc("Time between gusts, ticks.");
    }
    void apply(physics::FieldDefinition& field, float metres) const {
        field.kind = physics::FieldKind::Wind;
        field.velocity = velocity * metres;
        field.density = density;
        field.gust = gust * metres;
        field.gustSteps = static_cast<std::uint32_t>(gustTicks > 1 ? gustTicks : 1);
    }
};

}  // namespace plumb
