#pragma once

#include <string_view>

#include "editor/model/document/document.hpp"

namespace plumb::editor {

// Where the first entity of a prefab stands and how it is turned is no part of its file.

/// The message to a user that tries to move it.
inline constexpr const char* kRootStays =
    "The first entity of a prefab stays: each instance stands and turns as it was put into its scene";

/// Whether what is selected is the first entity of the open prefab and nothing else.
bool onlyRootSelected(const Document& document);

/// Whether a field of this entity is where the first entity of the open prefab stands, or how it is turned.
bool isPlaceOfRoot(const Document& document, ObjectId id, const TypeInfo& type, std::string_view field);

}  // namespace plumb::editor
