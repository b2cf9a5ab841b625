#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Pushes a body away from an explosion, each of its shapes for itself, at once.
void pushAway(World& world, const FieldDefinition& explosion, std::uint32_t body);

}  // namespace plumb::physics
