#include "editor/model/prefabs/go_inside.hpp"

#include "editor/model/document/bounds.hpp"
#include "editor/model/workspace.hpp"
#include "scene/components/colliders/chain_collider.hpp"
#include "scene/components/colliders/polygon_collider.hpp"
#include "scene/components/prefab_instance.hpp"

namespace plumb::editor {

void handleDoubleClick(Workspace& workspace, Vec2 point, float reach) {
    const Document& document = workspace.document;
    const std::vector<ObjectId> hits = pickAll(document, point, reach);
    if (hits.empty()) return;
    const EntityId entity = document.find(hits.front());
    if (document.world.has<PrefabPart>(entity)) return workspace.document.selection.set({hits.front()});
    if (document.world.has<PolygonCollider>(entity) || document.world.has<ChainCollider>(entity))
        workspace.useTool("tool.shape");
}

}  // namespace plumb::editor
