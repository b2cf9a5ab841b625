#include "scene/files/world_field_context.hpp"

#include <algorithm>

#include "reflect/json.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/files/tiles_json.hpp"

namespace plumb {

std::uint64_t WorldFieldContext::stableId(EntityId entity) const {
    const World& world = world_;
    const auto* found = world.find<SceneEntity>(entity);
    return found == nullptr ? 0 : found->id;
}

EntityId WorldFieldContext::entity(std::uint64_t stableId) const {
    if (!indexed_) {
        const World& world = world_;
        for (auto [entity, source] : world.query<const SceneEntity>(withPaused)) {
            index_.emplace_back(source.id, entity.id());
        }
        std::sort(index_.begin(), index_.end());
        indexed_ = true;
    }
    const auto found = std::lower_bound(index_.begin(), index_.end(), std::pair{stableId, EntityId{}});
    return found != index_.end() && found->first == stableId ? found->second : EntityId{};
}

Json WorldFieldContext::tilesToJson(TilesId tiles) const {
    const TileGrid* grid = std::as_const(world_).tiles().find(tiles);
    return grid == nullptr ? Json() : plumb::tilesToJson(*grid);
}

Result<TilesId> WorldFieldContext::tilesFromJson(const FieldInfo& field, const Json& json) {
    if (json.is_null()) return TilesId{};
    Result<ReadTiles> read = plumb::tilesFromJson(json);
    const std::string name{field.name};
    if (!read) {
        Error error = read.error();
        error.where = error.where.empty() ? name : name + "." + error.where;
        return error;
    }
    if (!read->problem.empty()) warn({name, read->problem, read->remedy});
    return world_.tiles().add(std::move(read->grid));
}

bool WorldFieldContext::sameTiles(TilesId a, TilesId b) const {
    if (a == b) return true;
    const TileGrid* first = std::as_const(world_).tiles().find(a);
    const TileGrid* second = std::as_const(world_).tiles().find(b);
    return first != nullptr && second != nullptr && *first == *second;
}

Entity findById(World& world, std::uint64_t stableId) {
    for (auto [entity, source] : world.query<const SceneEntity>(withPaused)) {
        if (source.id == stableId) return entity;
    }
    return {};
}

}  // namespace plumb
