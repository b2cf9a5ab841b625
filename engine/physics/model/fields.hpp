#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Adds a field and wakes the bodies that it acts on. FieldDefinition says which members a kind uses.
/// @error numbers that are not finite or out of range, a spring without a living body
Result<FieldId> createField(World& world, const FieldDefinition& definition);
/// Removes a field and wakes the bodies that it acted on. A stale id does nothing.
void destroyField(World& world, FieldId field);
/// Changes a field; its kind must stay the same.
/// @error as createField(); a stale id, another kind
Result<Done> setField(World& world, FieldId field, const FieldDefinition& definition);

/// Returns a default definition for a field that is gone.
[[nodiscard]] const FieldDefinition& definitionOf(const World& world, FieldId field);
[[nodiscard]] std::size_t fieldCount(const World& world);

}  // namespace plumb::physics
