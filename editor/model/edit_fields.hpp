#pragma once

#include <functional>
#include <span>
#include <vector>

#include "editor/model/expression.hpp"
#include "editor/model/field_value.hpp"

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

/// Changes the field of all of them by one command, or at once in the game that plays. Who lacks the
/// component is left out. What changes nothing is no command.
void editFields(Workspace& workspace, const FieldTarget& target, const ChangeValue& change);

/// Gives all fields of a component their defaults: one command, or at once in the game that plays.
void resetComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const TypeInfo& type);

/// Gives a component to all of these, also to those that lack it; in the game that plays, only its fields to
/// those that have it.
/// @param label  completes "Undo …"
void setComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const ComponentState& state,
                  std::string label);

/// The values as they are shown now. Who lacks the component is left out.
std::vector<FieldValue> readFields(const Workspace& workspace, const FieldTarget& target);

/// Types over a number of all of them; see typedNumber. Either all change or none.
/// @param at  bytes from the start of the value
/// @error     what is wrong with the text, or for which of them it has no result
Result<Done> typeNumber(Workspace& workspace, const FieldTarget& target, std::size_t at,
                        std::string_view text);

/// Which bytes of the value are not the same in all of them: none is zero where they differ. Numbers that are
/// equal count as the same.
class MixedBytes {
public:
    MixedBytes() = default;
    explicit MixedBytes(const FieldInfo& field) : bytes_(field.size) {}

    /// Marks where two values at addresses differ.
    void compare(const FieldInfo& field, const void* a, const void* b);
    [[nodiscard]] bool any() const { return any_; }
    [[nodiscard]] bool any(std::size_t at, std::size_t size) const;
    [[nodiscard]] bool bit(unsigned bit) const;
    /// Whether they are lists that are not all as long.
    [[nodiscard]] bool lengths() const { return lengths_; }

private:
    std::vector<std::byte> bytes_;
    bool any_ = false;
    bool lengths_ = false;
};

/// One field of what is selected, as the inspector shows it.
struct SharedField {
    FieldValue value;         ///< of the one selected last
    MixedBytes mixed;         ///< against the others
    bool isDefault = true;    ///< of all of them
    std::size_t holders = 0;  ///< how many have the component
};

/// @param fresh  a default component of the type
/// @pre   the last of the target has the component
SharedField sharedField(const Workspace& workspace, const FieldTarget& target, const ComponentState& fresh);

}  // namespace plumb::editor
