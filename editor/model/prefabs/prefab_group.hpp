#pragma once

#include <string>
#include <vector>

#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// What several entities have to do with prefabs, taken together: what the inspector's bar says and marks.
struct PrefabGroup {
    static constexpr std::size_t kMost = 500;  ///< entities that are compared: more would hold up the hand

    std::vector<std::string> prefabs;  ///< each once, in the order in which they were met
    std::size_t parts = 0;             ///< entities that come from a prefab
    bool compared = true;              ///< false: too many, and nothing below is known
    std::size_t changed = 0;           ///< values that these entities have for themselves, all counted
    PrefabOverrides overrides;         ///< what any of them has for itself
    std::string whyNotApply;           ///< why all of it cannot go into the prefabs; empty when it can
};
PrefabGroup prefabGroup(const PrefabEdit& edit, const std::vector<ObjectId>& ids);

/// Why what these have for themselves cannot go into their prefabs together: several instances of one prefab
/// say different things. Empty when it can.
std::string whyNotApply(const PrefabEdit& edit, const std::vector<ObjectId>& ids,
                        const PrefabScope& scope = {});

/// `applyToPrefab` for each of the entities, as one step of undo; of instances that say the same, one speaks
/// for all.
/// @error  as there, or they contradict each other; nothing has changed then
Result<Done> applyAllToPrefabs(const PrefabEdit& edit, const std::vector<ObjectId>& ids,
                               const PrefabScope& scope = {});

}  // namespace plumb::editor
