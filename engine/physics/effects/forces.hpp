#pragma once

#include <span>

#include "physics/effects/field_types.hpp"

namespace plumb::physics {

/// Acceleration of a body in a state by a list of fields, m/s2 and rad/s2. The only evaluation of smooth
/// forces: for all integrators, and for bodies that touch something.
Acceleration accelerationAt(const FieldView& view, std::span<const std::uint32_t> fields, std::uint32_t body,
                            const BodyState& state);

/// State of a body at the start of the step.
BodyState stateAtStart(const World& world, std::uint32_t body);

}  // namespace plumb::physics
