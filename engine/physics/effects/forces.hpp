#pragma once

#include <span>

#include "physics/effects/field_types.hpp"

namespace plumb::physics {

/// What the fields of a list do to a body in a state: m/s2 and rad/s2. The one function that evaluates smooth
/// forces: all integrators and the bodies that touch something go by it.
Acceleration accelerationAt(const FieldView& view, std::span<const std::uint32_t> fields, std::uint32_t body,
                            const BodyState& state);

/// A body at the start of the step.
BodyState stateAtStart(const World& world, std::uint32_t body);

}  // namespace plumb::physics
