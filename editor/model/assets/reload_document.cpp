#include "editor/model/assets/reload_document.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "core/log.hpp"
#include "editor/model/document/prefab_file.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb::editor {
namespace {

using Orders = std::map<std::uint64_t, int>;

Orders ordersOf(const World& world) {
    Orders orders;
    for (auto [entity, source] : world.query<const SceneEntity>(withPaused)) orders[source.id] = source.order;
    return orders;
}

/// Restores the entities' old order numbers, to which undo steps refer, after loading has assigned new ones.
/// Does nothing if the old numbers do not give the order of the loaded file.
void restoreOrders(World& world, const Orders& before) {
    std::map<int, std::uint64_t> read;
    for (auto [entity, source] : world.query<const SceneEntity>(without<PrefabPart>, withPaused))
        read[source.order] = source.id;
    const int* last = nullptr;
    for (const auto& [order, id] : read) {
        const auto was = before.find(id);
        if (was == before.end() || (last != nullptr && was->second <= *last)) return;
        last = &was->second;
    }
    for (auto [entity, source] : world.query<SceneEntity>(withPaused)) {
        if (const auto was = before.find(source.id); was != before.end()) source.order = was->second;
    }
}

std::shared_ptr<const SceneRest> restOf(Document& document) {
    LoadedScenes* scenes = document.world.findResource<LoadedScenes>();
    const LoadedScene* scene = scenes == nullptr ? nullptr : scenes->find(document.scene);
    return scene == nullptr ? nullptr : scene->rest;
}

/// Keeps the JSON members unknown to the engine of entities that no longer exist, in case undo recreates
/// them.
void restoreRest(Document& document, const SceneRest& before) {
    LoadedScenes* scenes = document.world.findResource<LoadedScenes>();
    LoadedScene* scene = scenes == nullptr ? nullptr : scenes->find(document.scene);
    if (scene == nullptr) return;
    auto rest =
        scene->rest == nullptr ? std::make_shared<SceneRest>() : std::make_shared<SceneRest>(*scene->rest);
    for (const auto& [id, kept] : before.entities) {
        if (!document.find(ObjectId{id})) rest->entities.try_emplace(id, kept);
    }
    scene->rest = std::move(rest);
}

}  // namespace

Result<LoadReport> reloadDocument(Document& document, const SceneContext& context, std::string_view text) {
    const std::string before = fileText(document.world, context, document.scene);
    const Orders orders = ordersOf(std::as_const(document.world));
    const std::shared_ptr<const SceneRest> rest = restOf(document);
    const std::vector<ObjectId> selected = document.selection.all();
    // Undo steps refer to tile grids of deleted entities, so all grids are kept.
    const TileStore tiles = document.world.tiles();
    const auto load = [&](std::string_view content) {
        unloadScene(document.world, document.scene);
        document.world.clear();
        document.world.tiles() = tiles;
        return loadFileText(document.world, context, document.scenePath, content);
    };
    Result<LoadReport> report = load(text);
    const Result<LoadReport> kept = report ? report : load(before);
    if (kept) document.scene = kept->scene;
    restoreOrders(document.world, orders);
    document.reindex();
    if (rest != nullptr) restoreRest(document, *rest);
    for (const ObjectId id : selected) {
        if (document.find(id)) document.selection.add(id);
    }
    if (AssetStore* assets = document.world.service<AssetStore>())
        loadAssets(document.world, context.types, *assets);
    return report;
}

}  // namespace plumb::editor
