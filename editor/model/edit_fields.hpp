#pragma once

#include <functional>
#include <span>
#include <vector>

#include "editor/model/document/expression.hpp"
#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

class Workspace;

/// A field of several entities.
struct FieldTarget {
    const TypeInfo& type;
    const FieldInfo& field;
    std::span<const ObjectId> objects;  ///< in the order of selecting
};

/// What an edit does to the value of one entity. The index is its place in the target.
using ChangeValue = std::function<void(FieldValue& value, std::size_t index)>;

/// Changes the field of all of them by one command, or at once in the game that plays. What lacks the
/// component is left out. What changes nothing is no command.
void editFields(Workspace& workspace, const FieldTarget& target, const ChangeValue& change);

/// Gives all fields of a component their defaults: one command, or at once in the game that plays.
void resetComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const TypeInfo& type);

/// Gives a component to all of these, also to those that lack it; in the game that plays, only its fields to
/// those that have it.
/// @param label  completes "Undo …"
void setComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const ComponentState& state,
                  std::string label);

/// The values as they are shown now. An entity without the component is left out.
std::vector<FieldValue> readFields(const Workspace& workspace, const FieldTarget& target);

/// Types over a number of all of them; see typedNumber. Either all change or none.
/// @param at  bytes from the start of the value
/// @error     what is wrong with the text, or for which of them it has no result
Result<Done> typeNumber(Workspace& workspace, const FieldTarget& target, std::size_t at,
                        std::string_view text);

}  // namespace plumb::editor
