#include "editor/model/tree_edit.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/commands/reorder.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/tools/tool.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

/// Returns the entities of the list that can be moved below the parent, each once, in file order.
std::vector<ObjectId> movable(const Document& document, const std::vector<ObjectId>& objects,
                              ObjectId parent) {
    const World& world = document.world;
    const EntityId into = document.find(parent);
    std::vector<ObjectId> wanted = outermost(document, objects);
    std::erase_if(wanted, [&](ObjectId id) {
        const EntityId entity = document.find(id);
        return !entity || id == prefabRootOf(document) || world.has<PrefabPart>(entity) || entity == into ||
               (into && isAncestor(world, entity, into));
    });
    std::sort(wanted.begin(), wanted.end());
    std::vector<ObjectId> ids;
    for (const ObjectId id : document.objects()) {
        if (std::binary_search(wanted.begin(), wanted.end(), id)) ids.push_back(id);
    }
    return ids;
}

ObjectId parentIn(const Document& document, ObjectId id) {
    return document.idOf(parentOf(document.world, document.find(id)));
}

/// Returns the center of the box around the entities, rounded to pixels, in the space of the parent.
Vec2 middleIn(const Document& document, const std::vector<ObjectId>& ids, ObjectId parent) {
    const std::optional<AABB> box = boundsOf(document, ids);
    if (!box) return {};
    const Pose middle{Vec2{std::round(box->center().x), std::round(box->center().y)}, 0.0f, {1.0f, 1.0f}};
    if (!parent) return middle.position;
    const Vec2 local = relativeTo(worldPose(document.world, document.find(parent)), middle).position;
    return isFinite(local) ? local : Vec2{};
}

}  // namespace

bool moveInTree(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects,
                const TreePlace& wanted, KeepPlace keep) {
    TreePlace place = wanted;
    if (!place.parent && prefabRootOf(document)) place = {prefabRootOf(document)};  // a prefab has one root
    const std::vector<ObjectId> moved = movable(document, objects, place.parent);
    std::vector<ObjectId> newcomers = moved;
    std::erase_if(newcomers, [&](ObjectId id) { return parentIn(document, id) == place.parent; });
    const bool ordered = place.beside && !document.world.has<PrefabPart>(document.find(place.beside)) &&
                         std::find(moved.begin(), moved.end(), place.beside) == moved.end();
    if (moved.empty() || (newcomers.empty() && !ordered)) return false;
    const std::string what =
        moved.size() == 1 ? document.nameOf(moved.front()) : format("{} entities", moved.size());
    Transaction transaction{undo, format("move {} in the tree", what)};
    if (!newcomers.empty()) undo.push(std::make_unique<Reparent>(newcomers, place.parent, keep));
    if (ordered) {
        auto reorder = std::make_unique<Reorder>(moved, place.beside, place.behind);
        const Reorder& done = *reorder;
        undo.push(std::move(reorder));
        if (newcomers.empty() && done.changesNothing(document)) return false;
    }
    return transaction.commit();
}

ObjectId groupEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects) {
    const std::vector<ObjectId> members = movable(document, objects, {});
    if (members.empty()) return {};
    const ObjectId parent = parentIn(document, members.front());
    Transaction transaction{undo, format("group {} entities", members.size())};
    auto create = createEntity(document, "group", middleIn(document, members, parent), parent);
    const ObjectId group = create->ids().front();
    undo.push(std::move(create));
    undo.push(std::make_unique<Reorder>(std::vector{group}, members.front(), false));
    undo.push(std::make_unique<Reparent>(members, group));
    transaction.commit();
    document.selection.set({group});
    return group;
}

bool stepInTree(Document& document, UndoStack& undo, ObjectId object, int by) {
    if (document.world.has<PrefabPart>(document.find(object))) return false;
    const ObjectId parent = parentIn(document, object);
    ObjectId beside;
    bool passed = false;
    for (const ObjectId id : document.objects()) {
        if (id == object) {
            if (by < 0) break;
            passed = true;
        } else if (parentIn(document, id) == parent && !document.world.has<PrefabPart>(document.find(id))) {
            if (by < 0 || passed) beside = id;
            if (passed) break;
        }
    }
    return beside && moveInTree(document, undo, {object}, {parent, beside, by > 0});
}

}  // namespace plumb::editor
