#pragma once

#include <deque>
#include <string>

#include "core/state_archive.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

/// A description of a type as a saved game contains it, so that a later version of the type can read its
/// components: names, places and kinds of the fields.
struct SavedType {
    std::string name;
    TypeInfo info;
    std::deque<std::string> names;  ///< of fields and of values of enums, to which `info` refers
};

/// Writes the description of a type. Without fields, only its size.
void writeType(StateArchive& archive, std::string_view name, const TypeInfo& type);
/// Reads a description; it is safe to use with convertComponent(), else the archive is not ok().
/// @param type  receives the description; must not be moved afterwards
void readType(StateArchive& archive, SavedType& type);

/// True if values of the saved type can be copied as they are.
bool sameFields(const TypeInfo& saved, const TypeInfo& now);

/// Writes or reads a value with the description of its type. @param value  of this type
void archiveFields(StateArchive& archive, const TypeInfo& type, void* value);

/// Writes the key of a type by its name, or reads it; kMaxTypes if the program has no such type.
void archiveKey(StateArchive& archive, TypeKey& key);

}  // namespace plumb
