#include "editor/model/commands/reparent.hpp"

#include <utility>

#include "ecs/hierarchy.hpp"
#include "editor/model/document/document.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

/// Sets the transform so that the entity has this world pose. If the parent is scaled to zero, or the result
/// would overflow, the transform is left unchanged.
void place(World& world, EntityId entity, const Pose& pose) {
    const EntityId parent = parentOf(std::as_const(world), entity);
    const Pose outer = parent ? worldPose(world, parent) : Pose{};
    if (outer.scale.x == 0.0f || outer.scale.y == 0.0f) return;
    const Pose own = relativeTo(outer, pose);
    if (!isFinite(own.position) || !isFinite(own.scale)) return;
    world.get<Transform>(entity) = Transform{own.position, own.rotation, own.scale};
}

}  // namespace

Reparent::Reparent(std::vector<ObjectId> objects, ObjectId parent, KeepPlace keep)
    : parent_{parent}, keep_{keep} {
    for (const ObjectId object : objects) {
        changes_.push_back({object, {}, std::nullopt});
    }
}

void Reparent::apply(Document& document) {
    World& world = document.world;
    ++document.treeRevision;
    for (Change& change : changes_) {
        const EntityId entity = document.find(change.object);
        const Pose pose = worldPose(world, entity);
        change.parentBefore = document.idOf(parentOf(std::as_const(world), entity));
        change.transformBefore.reset();
        // setParent refuses to create a cycle; then `revert` changes nothing either.
        const bool same = change.parentBefore == parent_;
        if (same || world.has<PrefabPart>(entity) || !setParent(world, entity, document.find(parent_)))
            continue;
        const Transform* transform = std::as_const(world).find<Transform>(entity);
        if (transform == nullptr || keep_ == KeepPlace::InParent) continue;
        change.transformBefore = *transform;
        place(world, entity, pose);
    }
}

void Reparent::revert(Document& document) {
    ++document.treeRevision;
    for (auto change = changes_.rbegin(); change != changes_.rend(); ++change) {
        const EntityId entity = document.find(change->object);
        setParent(document.world, entity, document.find(change->parentBefore));
        if (change->transformBefore) document.world.get<Transform>(entity) = *change->transformBefore;
    }
}

}  // namespace plumb::editor
