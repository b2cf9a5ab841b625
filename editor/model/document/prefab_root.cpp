#include "editor/model/document/prefab_root.hpp"

#include <cstring>

#include "editor/model/document/prefab_file.hpp"
#include "scene/files/prefab.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {

ObjectId prefabRootOf(const Document& document) {
    return isPrefabFile(document.scenePath) ? ObjectId{Prefab::kRootPart} : ObjectId{};
}

void belowPrefabRoot(const Document& document, std::vector<EntityState>& states) {
    const ObjectId first = prefabRootOf(document);
    const EntityId root = document.find(first);
    if (!root) return;
    const Pose outer = worldPose(document.world, root);
    for (EntityState& state : states) {
        if (state.parent || state.id == first) continue;
        state.parent = first;
        for (ComponentState& component : state.components) {
            if (component.type->key != typeKey<Transform>()) continue;
            Transform transform;
            std::memcpy(&transform, component.bytes.data(), sizeof transform);
            const Pose own = relativeTo(outer, {transform.position, transform.rotation, transform.scale});
            if (!isFinite(own.position) || !isFinite(own.scale)) continue;
            transform = Transform{own.position, own.rotation, own.scale};
            std::memcpy(component.bytes.data(), &transform, sizeof transform);
        }
    }
}

}  // namespace plumb::editor
