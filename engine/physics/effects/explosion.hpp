#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Applies the impulse of an explosion to each shape of a body.
void pushAway(World& world, const FieldDefinition& explosion, std::uint32_t body);

}  // namespace plumb::physics
