#include "editor/model/commands/delete_entities.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"

namespace plumb::editor {
namespace {

bool holdsEntities(const FieldInfo& field) {
    return field.kind == FieldKind::Entity ||
           (field.kind == FieldKind::List && field.element == FieldKind::Entity);
}

}  // namespace

std::string DeleteEntities::label() const {
    return objects_.size() == 1 ? "delete entity" : format("delete {} entities", objects_.size());
}

void DeleteEntities::apply(Document& document) {
    selected_ = document.selection.all();
    const std::vector<ObjectId> deleted = withDescendants(document, objects_);
    states_.clear();
    for (const ObjectId id : deleted) {
        states_.push_back(readEntity(document, id));
    }
    cutReferences(document, deleted);
    eraseEntities(document, deleted);
}

void DeleteEntities::revert(Document& document) {
    insertEntities(document, states_);
    for (const Reference& reference : references_) {
        void* component = document.world.find(*reference.type, document.find(reference.owner));
        writeField(document, *reference.field, component, reference.value);
    }
    document.selection.set(selected_);
}

void DeleteEntities::cutReferences(Document& document, const std::vector<ObjectId>& deleted) {
    references_.clear();
    std::vector<EntityId> targets;
    for (const ObjectId id : deleted) {
        targets.push_back(document.find(id));
    }
    std::sort(targets.begin(), targets.end());
    for (const TypeInfo& type : document.types().all()) {
        if (type.key == typeKey<Parent>() || type.key == typeKey<Children>()) continue;
        for (const FieldInfo& field : type.fields) {
            if (!holdsEntities(field)) continue;
            for (const ObjectId owner : document.objects()) {
                const EntityId entity = document.find(owner);
                void* component =
                    document.world.has(type, entity) ? document.world.find(type, entity) : nullptr;
                if (component == nullptr || !refersTo(field, component, targets)) continue;
                if (std::binary_search(targets.begin(), targets.end(), entity)) continue;
                references_.push_back({owner, &type, &field, readField(document, field, component)});
                clearReferences(field, component, targets);
            }
        }
    }
}

}  // namespace plumb::editor
