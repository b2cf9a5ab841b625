#pragma once

#include <string_view>

#include "editor/model/document/document.hpp"

namespace plumb::editor {

// The position and rotation of a prefab's root are not part of its file.

/// Message to a user that tries to move the root.
inline constexpr const char* kRootCannotMove =
    "The root of a prefab cannot be moved or rotated: each instance has its own position and rotation";

/// True if only the root of the open prefab is selected.
bool onlyRootSelected(const Document& document);

/// True if the entity is the root of the open prefab and the field is its position or rotation.
bool isPlaceOfRoot(const Document& document, ObjectId id, const TypeInfo& type, std::string_view field);

}  // namespace plumb::editor
