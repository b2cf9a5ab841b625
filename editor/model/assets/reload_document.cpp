#include "editor/model/assets/reload_document.hpp"

#include <cstdint>
#include <map>
#include <utility>

#include "core/log.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {
namespace {

using Orders = std::map<std::uint64_t, int>;

Orders ordersOf(const World& world) {
    Orders orders;
    for (auto [entity, source] : world.query<const SceneEntity>(withPaused)) orders[source.id] = source.order;
    return orders;
}

/// Reading a file numbers its entities anew. Steps that can be undone put theirs back by the old numbers, so
/// these come back, as long as they still say the same order.
void giveBackOrders(World& world, const Orders& before) {
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

}  // namespace

Result<LoadReport> reloadDocument(Document& document, const SceneContext& context, std::string_view text) {
    const std::string before = sceneToJson(document.world, context, document.scene);
    const Orders orders = ordersOf(std::as_const(document.world));
    const std::vector<ObjectId> selected = document.selection.all();
    // Steps that can be undone name grids of entities that are not there now: no grid may go.
    const TileStore tiles = document.world.tiles();
    const auto load = [&](std::string_view content) {
        unloadScene(document.world, document.scene);
        document.world.clear();
        document.world.tiles() = tiles;
        return loadScene(document.world, context, document.scenePath, content);
    };
    Result<LoadReport> report = load(text);
    const Result<LoadReport> kept = report ? report : load(before);
    if (kept) document.scene = kept->scene;
    giveBackOrders(document.world, orders);
    document.reindex();
    for (const ObjectId id : selected) {
        if (document.find(id)) document.selection.add(id);
    }
    if (AssetStore* assets = document.world.service<AssetStore>())
        loadAssets(document.world, context.types, *assets);
    return report;
}

}  // namespace plumb::editor
