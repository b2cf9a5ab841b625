#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

class Workspace;

// Clipboard texts: values and components as JSON, as in scene files.

/// Returns a value as JSON, as in a scene file: `[3, 4]`, `"#ff8000"`, `true`.
std::string valueText(Workspace& workspace, const TypeInfo& type, const FieldInfo& field,
                      const FieldValue& value);

/// Reads a value from JSON text. A number outside the field's range is clamped to it.
/// @error  the text is not a value of the field's type
Result<FieldValue> valueFromText(Workspace& workspace, const TypeInfo& type, const FieldInfo& field,
                                 std::string_view text);

/// Reads a color of 3, 6 or 8 hexadecimal digits, with or without a leading #.
Result<FieldValue> colorFromText(std::string_view text);
std::string colorText(const FieldValue& color);

/// Returns a component with all its saved fields as clipboard text.
/// @pre  the entity has the component
std::string componentText(Workspace& workspace, const TypeInfo& type, ObjectId id);

/// Returns the type of the component in a clipboard text, null if the text holds none. Reads only the first
/// 120 characters.
const TypeInfo* componentInText(const TypeRegistry& types, std::string_view text);

/// Pastes the component of a clipboard text onto the entities, as one undo step, and adds it where it is
/// missing. In the running game, only the entities that have the component are changed.
/// @error  the text cannot be read; nothing has changed then
Result<Done> pasteComponent(Workspace& workspace, const std::vector<ObjectId>& ids, std::string_view text);

}  // namespace plumb::editor
