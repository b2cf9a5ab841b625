#pragma once

#include "scene/field_region.hpp"

namespace plumb {

/// Air that moves: takes along what is light and large.
struct WindField : FieldRegion {
    Vec2 velocity{200.0f, 0.0f};  ///< px/s
    float density = 1.0f;         ///< kg/m^2: half that of the air times the drag of what is in it
    float gust = 0.0f;            ///< px/s: at most so much more or less
    int gustTicks = 30;           ///< ticks from gust to gust

    static void describe(TypeBuilder<WindField>& type) {
        type.name("WindField").doc("Air that moves, in gusts.");
        describeRegion(type);
        type.field<&WindField::velocity>("velocity").unit(Unit::PixelsPerSecond);
        type.field<&WindField::density>("density").range(0.0f, 1e6f).doc("How hard it blows.");
        type.field<&WindField::gust>("gust")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 1e5f)
            .doc("At most so much more or less.");
        type.field<&WindField::gustTicks>("gustTicks")
            .unit(Unit::Ticks)
            .range(1.0f, 1e6f)
            .doc("From gust to gust.");
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
