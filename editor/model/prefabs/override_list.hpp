#pragma once

#include <string>
#include <vector>

#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// One thing that an instance has for itself, as people read it.
struct OverrideRow {
    ObjectId object;                 ///< the entity of the instance
    const TypeInfo* type = nullptr;  ///< null: the whole part was taken out
    std::string field;               ///< empty: the component was added, or taken out
    std::string entity;              ///< its name
    std::string prefab;              ///< what the prefab says
    std::string here;                ///< what the instance says

    [[nodiscard]] PrefabScope scope() const { return {type, field}; }
};

/// All that the instance of an entity has for itself, in the order of the prefab.
std::vector<OverrideRow> overrideList(const PrefabEdit& edit, ObjectId id);

/// Gives one of them back to the prefab. @return false when there was nothing to do
bool revertOverride(const PrefabEdit& edit, const OverrideRow& row);

}  // namespace plumb::editor
