#pragma once

#include <string>
#include <vector>

#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// Summary of the prefabs and overrides of several entities, shown in the inspector.
struct PrefabGroup {
    static constexpr std::size_t kMost = 500;  ///< maximum number of entities to compare, to keep the UI fast

    std::vector<std::string> prefabs;  ///< paths, without duplicates, in order of first use
    std::size_t parts = 0;             ///< number of entities that belong to a prefab instance
    bool compared = true;              ///< false: too many entities; the fields below are not computed
    std::size_t changed = 0;           ///< number of overrides of all entities together
    PrefabOverrides overrides;         ///< union of the overrides of all entities
    std::string whyNotApply;           ///< reason why they cannot be applied together; empty if they can
};
/// Computes the summary for these entities.
PrefabGroup prefabGroup(const PrefabEdit& edit, const std::vector<ObjectId>& ids);

/// Returns the reason why the overrides of these entities cannot be applied together: several instances of
/// one prefab have different overrides. Empty if they can be applied.
std::string whyNotApply(const PrefabEdit& edit, const std::vector<ObjectId>& ids,
                        const PrefabScope& scope = {});

/// Calls `applyToPrefab` for the entities, once per group of equal overrides, as one undo step.
/// @error  an error of `applyToPrefab`, or instances with different overrides; then nothing has changed
Result<Done> applyAllToPrefabs(const PrefabEdit& edit, const std::vector<ObjectId>& ids,
                               const PrefabScope& scope = {});

}  // namespace plumb::editor
