#include <cmath>

#include "physics/effects/field_types.hpp"

namespace plumb::physics {

/// a = strength / distance^2 (Newton), or strength * distance. Softened as by H. Plummer, 1911.
Acceleration attractor(const FieldView& view, const FieldDefinition& field, std::uint32_t,
                       const BodyState& state) {
    const Place centre = field.a ? view.stateOf(view, field.a.index).centre : field.place;
    const Vec2 way = centre - state.centre;
    if (field.linear) return {field.strength * way, 0.0f};
    const float square = lengthSquared(way) + field.length * field.length;
    if (square <= 1.0e-12f) return {};
    return {(field.strength / (square * std::sqrt(square))) * way, 0.0f};
}

}  // namespace plumb::physics
