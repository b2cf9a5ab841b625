#include "editor/model/commands/insert_entities.hpp"

#include "core/text.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {

void InsertEntities::apply(Document& document) {
    insertEntities(document, states_);
    document.selection.set(outermost(document, ids()));
}

void InsertEntities::revert(Document& document) { eraseEntities(document, ids()); }

std::vector<ObjectId> InsertEntities::ids() const {
    std::vector<ObjectId> ids;
    for (const EntityState& state : states_) {
        ids.push_back(state.id);
    }
    return ids;
}

std::unique_ptr<InsertEntities> createEntity(Document& document, std::string_view name, Vec2 position,
                                             ObjectId parent) {
    const TypeRegistry& types = document.types();
    EntityState state{document.newId(), parent, {}};
    const SceneEntity part{state.id.value, document.nextOrder(), document.scene};
    const Name called{document.world.texts().add(name)};
    const Transform place{position};
    state.components.push_back({&types.of<SceneEntity>(), FieldValue::of(part).bytes});
    if (!name.empty()) state.components.push_back({&types.of<Name>(), FieldValue::of(called).bytes});
    state.components.push_back({&types.of<Transform>(), FieldValue::of(place).bytes});
    std::vector<EntityState> states;
    states.push_back(std::move(state));
    belowPrefabRoot(document, states);
    return std::make_unique<InsertEntities>("create entity", std::move(states));
}

std::unique_ptr<InsertEntities> duplicateEntities(Document& document, const std::vector<ObjectId>& objects) {
    std::vector<EntityState> states;
    for (const ObjectId id : withDescendants(document, objects)) {
        states.push_back(readEntity(document, id));
    }
    const std::string label =
        objects.size() == 1 ? "duplicate entity" : format("duplicate {} entities", objects.size());
    std::vector<EntityState> copies = copiesOf(document, std::move(states));
    belowPrefabRoot(document, copies);
    return std::make_unique<InsertEntities>(label, std::move(copies));
}

}  // namespace plumb::editor
