#include "editor/model/prefabs/prefab_edit.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/document/prefab_file.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {
namespace {

/// Returns the root entities of the instances that these entities belong to, without duplicates.
std::vector<ObjectId> rootsOf(const PrefabEdit& edit, const std::vector<ObjectId>& ids) {
    std::vector<ObjectId> roots;
    for (const ObjectId id : ids) {
        const auto part = InstancePart::of(edit.document, edit.prefabs, id);
        if (part && std::find(roots.begin(), roots.end(), part->root()) == roots.end())
            roots.push_back(part->root());
    }
    return roots;
}

/// Returns the prefab's component; for the root entity with the instance's own position, rotation and
/// transient fields.
ComponentState revertedState(const PrefabEdit& edit, const InstancePart& part, const TypeInfo& type) {
    ComponentState state = part.baseOf(type);
    const EntityId entity = edit.document.find(part.id());
    if (!part.isRoot() || !edit.document.world.has(type, entity)) return state;
    const ComponentState now = readComponent(edit.document, type, entity);
    for (const FieldInfo& field : type.fields) {
        if (!isInstancePose(type, field.name) && !field.transient) continue;
        std::memcpy(field.in(static_cast<void*>(state.bytes.data())),
                    field.in(static_cast<const void*>(now.bytes.data())), field.size);
    }
    return state;
}

void revertComponent(const PrefabEdit& edit, ObjectId id, const TypeInfo& type) {
    const auto part = InstancePart::of(edit.document, edit.prefabs, id);
    if (!part || !canOverride(type)) return;
    const bool here = edit.document.world.has(type, edit.document.find(id));
    const bool there = part->prefabHas(type);
    if (here == there && (!here || part->differences(type).empty())) return;
    std::optional<ComponentState> state;
    if (there) state = revertedState(edit, *part, type);
    std::vector<ChangeComponents::Change> changes;
    changes.push_back({id, std::move(state)});
    edit.undo.push(std::make_unique<ChangeComponents>("revert", type, std::move(changes)));
}

void revertField(const PrefabEdit& edit, ObjectId id, const TypeInfo& type, std::string_view name) {
    const auto part = InstancePart::of(edit.document, edit.prefabs, id);
    const FieldInfo* field = type.find(name);
    if (!part || field == nullptr || !part->prefabHas(type)) return;
    if (!edit.document.world.has(type, edit.document.find(id)) ||
        !part->differences(type).contains(std::string{name}))
        return;
    const ComponentState base = part->baseOf(type);
    const auto* at = static_cast<const std::byte*>(field->in(static_cast<const void*>(base.bytes.data())));
    std::vector<SetField::Change> changes;
    changes.push_back({id, FieldValue{std::vector<std::byte>(at, at + field->size)}});
    edit.undo.push(std::make_unique<SetField>(type, *field, std::move(changes)));
}

void revertInstance(const PrefabEdit& edit, ObjectId root) {
    const auto part = InstancePart::of(edit.document, edit.prefabs, root);
    if (!part) return;
    std::vector<EntityState> missing = missingParts(edit.document, part->prefab(), root);
    if (!missing.empty())
        edit.undo.push(std::make_unique<InsertEntities>("restore parts", std::move(missing)));
    for (const ObjectId id : InstancePart::of(edit.document, edit.prefabs, root)->all()) {
        for (const TypeInfo& type : edit.document.types().all()) {
            revertComponent(edit, id, type);
        }
    }
}

}  // namespace

bool revertToPrefab(const PrefabEdit& edit, const std::vector<ObjectId>& ids, const PrefabScope& scope) {
    const std::string what = scope.type == nullptr ? std::string{"instance"}
                             : scope.field.empty() ? std::string{scope.type->name}
                                                   : format("{}.{}", scope.type->name, scope.field);
    const std::vector<ObjectId> selected = edit.document.selection.all();
    Transaction transaction{edit.undo, format("revert {} to prefab", what)};
    if (scope.type == nullptr) {
        for (const ObjectId root : rootsOf(edit, ids)) revertInstance(edit, root);
    } else {
        for (const ObjectId id : ids) {
            scope.field.empty() ? revertComponent(edit, id, *scope.type)
                                : revertField(edit, id, *scope.type, scope.field);
        }
    }
    const bool changed = transaction.commit();
    edit.document.selection.set(selected);
    return changed;
}

bool restorePart(const PrefabEdit& edit, ObjectId wanted) {
    for (const ObjectId id : edit.document.objects()) {
        const auto instance = InstancePart::of(edit.document, edit.prefabs, id);
        if (!instance || !instance->isRoot()) continue;
        std::vector<EntityState> states;
        ObjectId next = wanted;
        std::vector<EntityState> missing = missingParts(edit.document, instance->prefab(), id);
        // Collects the part and its missing ancestors. `missing` lists parents before children.
        for (auto state = missing.rbegin(); state != missing.rend(); ++state) {
            if (state->id != next) continue;
            next = state->parent;
            states.insert(states.begin(), std::move(*state));
        }
        if (states.empty()) continue;
        Transaction transaction{edit.undo, "restore a part of a prefab"};
        std::vector<ObjectId> ids;
        for (const EntityState& state : states) ids.push_back(state.id);
        edit.undo.push(std::make_unique<InsertEntities>("restore parts", std::move(states)));
        for (const ObjectId part : ids) {
            for (const TypeInfo& type : edit.document.types().all()) revertComponent(edit, part, type);
        }
        return transaction.commit();
    }
    return false;
}

Result<Done> addInstance(const PrefabEdit& edit, std::string_view path, Vec2 position) {
    const std::string name{path};
    if (edit.prefabs == nullptr)
        return Error{name, "prefabs need a project, and none is open", "open a project"};
    const Result<const Prefab*> prefab = edit.prefabs->find(path);
    if (!prefab) return prefab.error();
    Document& document = edit.document;
    if (prefabRootOf(document) && isInside(edit.root, document.scenePath, path))
        return Error{name, "a prefab cannot contain itself",
                     "choose a prefab other than the edited one and those that contain it"};
    const TypeRegistry& types = document.types();
    Transaction transaction{edit.undo, format("add {}", path)};
    auto command = createEntity(document, (*prefab)->entities.front().name, position);
    const ObjectId root = command->ids().front();
    edit.undo.push(std::move(command));
    const PrefabInstance link{{document.world.texts().add(path)}};
    const TypeInfo& type = types.of<PrefabInstance>();
    std::vector<ChangeComponents::Change> changes;
    changes.push_back({root, ComponentState{&type, FieldValue::of(link).bytes}});
    edit.undo.push(std::make_unique<ChangeComponents>("make instance", type, std::move(changes)));
    revertInstance(edit, root);
    transaction.commit();
    document.selection.set({root});
    return Done{};
}

}  // namespace plumb::editor
