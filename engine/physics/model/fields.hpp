#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Adds a field and wakes the bodies that it acts on.
/// @error numbers that are not finite or out of range, a spring without an existing body
Result<FieldId> createField(World& world, const FieldDefinition& definition);
/// Removes a field and wakes the bodies that it acted on. A stale id does nothing.
void destroyField(World& world, FieldId field);
/// Changes a field, except its kind.
/// @error the same errors as createField(), a stale id, another kind
Result<Done> setField(World& world, FieldId field, const FieldDefinition& definition);

/// Returns the definition of a field, or the default if it was destroyed.
[[nodiscard]] inline const FieldDefinition& definitionOf(const World& world, FieldId field) {
    return readOf(world, world.fields.all, field).definition;
}
[[nodiscard]] inline std::size_t fieldCount(const World& world) {
    return world.fields.all.size() - world.fields.free.size();
}

}  // namespace plumb::physics
