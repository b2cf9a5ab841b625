#include "editor/model/commands/become_instance.hpp"

#include <array>

#include "editor/model/commands/reorder.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {
namespace {

std::array<const TypeInfo*, 3> ties(const Document& document) {
    const TypeRegistry& types = document.types();
    return {&types.of<SceneEntity>(), &types.of<PrefabInstance>(), &types.of<PrefabPart>()};
}

}  // namespace

void BecomeInstance::rename(Document& document, ObjectId from, ObjectId to) {
    if (from == to) return;
    const EntityId entity = document.find(from);
    document.forget(from);
    document.world.get<SceneEntity>(entity).id = to.value;
    document.remember(to, entity);
}

void BecomeInstance::apply(Document& document) {
    World& world = document.world;
    selected_ = document.selection.all();
    before_.clear();
    line_ = fileOrder(document);
    const std::int32_t order = world.get<SceneEntity>(document.find(root_)).order;
    const auto keep = [&](ObjectId id, ObjectId made) {
        Before& entity = before_.emplace_back(Before{id, made, {}});
        for (const TypeInfo* type : ties(document)) {
            if (world.has(*type, document.find(id)))
                entity.states.push_back(readComponent(document, *type, document.find(id)));
        }
    };
    keep(root_, root_);
    world.add<PrefabInstance>(document.find(root_), PrefabInstance{{world.texts().add(path_)}});
    for (const auto& [id, part] : parts_) {
        const ObjectId made{combinedId(root_.value, part)};
        keep(id, made);
        const EntityId entity = document.find(id);
        world.remove<PrefabInstance>(entity);
        world.add<PrefabPart>(entity, PrefabPart{root_.value, part});
        world.get<SceneEntity>(entity).order = order;
        rename(document, id, made);
    }
    document.reordered();
    prefabs_.forget();
    document.selection.set({root_});
}

void BecomeInstance::revert(Document& document) {
    World& world = document.world;
    for (auto entity = before_.rbegin(); entity != before_.rend(); ++entity) {
        const EntityId at = document.find(entity->made);
        rename(document, entity->made, entity->id);
        for (const TypeInfo* type : ties(document)) world.remove(*type, at);
        for (const ComponentState& state : entity->states) writeComponent(document, at, state);
    }
    placeInOrder(document, line_);
    prefabs_.forget();
    document.selection.set(selected_);
}

}  // namespace plumb::editor
