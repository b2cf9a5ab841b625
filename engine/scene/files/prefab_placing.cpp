#include "scene/files/prefab_placing.hpp"

#include <algorithm>

#include "assets/asset_store.hpp"
#include "ecs/hierarchy.hpp"
#include "reflect/component_json.hpp"
#include "reflect/json.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/name.hpp"
#include "scene/components/transform.hpp"

namespace plumb {
namespace {

void addComponents(World& world, const TypeRegistry& types, EntityId id, const Json& components,
                   FieldContext& context) {
    std::vector<FieldProblem> ignored;  // reported when the file was read
    for (const auto& [name, fields] : *components.get_ptr<const Json::object_t*>()) {
        if (const TypeInfo* type = types.find(name)) {
            componentFromJson(*type, world.add(*type, id), fields, context, ignored);
        }
    }
}

}  // namespace

EntityId PartContext::entity(std::uint64_t part) const {
    for (std::size_t i = 0; i < placed_.entities.size(); ++i) {
        if (prefab_.entities[i].part == part) return placed_.entities[i];
    }
    return WorldFieldContext::entity(part);
}

PlacedPrefab placePrefab(World& world, const TypeRegistry& types, const Prefab& prefab) {
    PlacedPrefab placed;
    for (std::size_t i = 0; i < prefab.entities.size(); ++i) placed.entities.push_back(world.createEntity());
    PartContext context{world, prefab, placed};
    for (std::size_t i = 0; i < prefab.entities.size(); ++i) {
        const PrefabEntity& entity = prefab.entities[i];
        if (!entity.name.empty()) world.add<Name>(placed.entities[i]).text = world.texts().add(entity.name);
        if (entity.parent != 0) setParent(world, placed.entities[i], context.entity(entity.parent));
        addComponents(world, types, placed.entities[i], entity.components, context);
    }
    return placed;
}

Entity spawnPrefab(World& world, const TypeRegistry& types, const Prefab& prefab, Vec2 position) {
    // Now, not when scenes change: what a tick does must not depend on what was loaded before.
    if (auto* assets = world.service<AssetStore>()) {
        for (const PrefabAsset& asset : prefab.assets) assets->load(asset.kind, asset.path);
    }
    const PlacedPrefab placed = placePrefab(world, types, prefab);
    const Entity root = world.entity(placed.entities.front());
    if (Transform* transform = root.find<Transform>()) {
        teleport(*transform, position);
    } else {
        root.addComponent<Transform>(position);
    }
    return root;
}

PrefabValue::PrefabValue(const TypeInfo& type, const Json* fields, FieldContext& context)
    : memory_(type.size / sizeof(std::max_align_t) + 1) {
    type.construct(memory_.data());
    if (fields == nullptr) return;
    std::vector<FieldProblem> ignored;
    componentFromJson(type, memory_.data(), *fields, context, ignored);
}

}  // namespace plumb
