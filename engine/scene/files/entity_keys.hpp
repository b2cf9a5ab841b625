#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

class TypeRegistry;
struct TypeInfo;

// What scene files and prefab files may say about an entity.

/// True for keys that the engine does not read but that are valid: values of the game, and data that an
/// importer could not express in components. They are kept like unknown keys, without a warning.
bool isEntityNote(std::string_view key);

/// Returns the component type of this name; null if there is none, or if files have a key of their own for
/// it, e.g. "name".
const TypeInfo* componentOfFiles(const TypeRegistry& types, std::string_view name);

/// Returns the problem of a name for which componentOfFiles() is null.
Error unknownComponent(const TypeRegistry& types, std::string where, std::string_view name);

}  // namespace plumb
