#pragma once

#include <string>
#include <vector>

#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// One difference between a prefab instance and its prefab, for display.
struct OverrideRow {
    ObjectId object;                 ///< entity of the instance that differs
    const TypeInfo* type = nullptr;  ///< null: the whole entity was removed from the instance
    std::string field;               ///< empty: the component was added or removed
    std::string entity;              ///< name of the entity
    std::string prefab;  ///< value in the prefab; for a whole component or entity "present" or "-"
    std::string here;    ///< value in the instance; or "added" or "removed"

    [[nodiscard]] PrefabScope scope() const { return {type, field}; }
};

/// Returns all differences between the instance that an entity belongs to and the prefab, in prefab order.
std::vector<OverrideRow> overrideList(const PrefabEdit& edit, ObjectId id);

/// Reverts one difference to the prefab's state. @return false if nothing had to be changed
bool revertOverride(const PrefabEdit& edit, const OverrideRow& row);

}  // namespace plumb::editor
