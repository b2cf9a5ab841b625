#include <cmath>

#include "physics/effects/field_types.hpp"

namespace plumb::physics {

/// a = strength / distance^2 (Newton), or strength * distance. Softened as by H. Plummer, 1911.
Acceleration attractor(const FieldView& view, const FieldDefinition& field, std::uint32_t,
                       const BodyState& state) {
    const WorldPosition centre = field.a ? view.stateOf(view, field.a.index).centre : field.place;
    const Vec2 displacement = centre - state.centre;
    if (field.linear) return {field.strength * displacement, 0.0f};
    const float square = lengthSquared(displacement) + field.length * field.length;
    if (square <= 1.0e-12f) return {};
    return {(field.strength / (square * std::sqrt(square))) * displacement, 0.0f};
}

}  // namespace plumb::physics
