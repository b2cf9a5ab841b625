#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

class Workspace;

// Values and components as JSON text, in the words of scene files: what goes to the clipboard and back.

/// A value as a scene file has it: `[3, 4]`, `"#ff8000"`, `true`.
std::string valueText(Workspace& workspace, const TypeInfo& type, const FieldInfo& field,
                      const FieldValue& value);

/// The value of such a text. A number past the field's range becomes the nearest in it.
/// @error  what was expected and what was found
Result<FieldValue> valueFromText(Workspace& workspace, const TypeInfo& type, const FieldInfo& field,
                                 std::string_view text);

/// A color as people type it: with or without #, in 3, 6 or 8 digits.
Result<FieldValue> colorFromText(std::string_view text);
std::string colorText(const FieldValue& color);

/// A whole component with all its fields.
/// @pre  the entity has it
std::string componentText(Workspace& workspace, const TypeInfo& type, ObjectId id);

/// The type of the component that a text holds; null when it is something else. Looks only at its beginning.
const TypeInfo* componentInText(const TypeRegistry& types, std::string_view text);

/// Gives the component of the text to all of these, those that lack it too; one step of undo. In the game
/// that plays, to those that have it.
/// @error  what is wrong with the text; nothing has changed then
Result<Done> pasteComponent(Workspace& workspace, const std::vector<ObjectId>& ids, std::string_view text);

}  // namespace plumb::editor
