#pragma once

#include <functional>
#include <span>
#include <vector>

#include "editor/model/document/expression.hpp"
#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

class Workspace;

/// One field of a component, on several entities.
struct FieldTarget {
    const TypeInfo& type;
    const FieldInfo& field;
    std::span<const ObjectId> objects;  ///< in order of selection
};

/// Edits the value of one entity in place. `index` is the entity's index in `FieldTarget::objects`.
using ChangeValue = std::function<void(FieldValue& value, std::size_t index)>;

/// Changes the field on all entities of the target that have the component: by one command (none if no value
/// changes), or directly in the running game.
void editFields(Workspace& workspace, const FieldTarget& target, const ChangeValue& change);

/// Resets all fields of a component to their defaults: by one command, or directly in the running game.
void resetComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const TypeInfo& type);

/// Adds a component with this state to the entities, or overwrites it where they have one. In the running
/// game, only the entities that have the component are changed.
/// @param label  completes "Undo …"
void setComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const ComponentState& state,
                  std::string label);

/// Returns the current values, from the running game if there is one. Entities without the component are left
/// out.
std::vector<FieldValue> readFields(const Workspace& workspace, const FieldTarget& target);

/// Evaluates a typed text (typedNumber in expression.hpp) for each entity and sets the number to the result.
/// Either all entities change or none.
/// @param at  byte offset of the number in the value
/// @error     the text cannot be evaluated for one of the entities
Result<Done> typeNumber(Workspace& workspace, const FieldTarget& target, std::size_t at,
                        std::string_view text);

}  // namespace plumb::editor
