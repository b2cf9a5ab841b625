#pragma once

#include <utility>
#include <vector>

#include "ecs/world.hpp"
#include "reflect/field_context.hpp"

namespace plumb {

/// Resolves the ids in a world's components: texts, tile grids, and stable ids of scene entities.
/// Short-lived: it builds its index of entities at the first lookup.
class WorldFieldContext : public FieldContext {
public:
    explicit WorldFieldContext(World& world) : world_{world} {}

    std::vector<Error> warnings;

    [[nodiscard]] std::string_view text(TextId id) const override { return world_.texts().find(id); }
    TextId keepText(std::string_view text) override { return world_.texts().add(text); }
    [[nodiscard]] std::uint64_t stableId(EntityId entity) const override;
    [[nodiscard]] EntityId entity(std::uint64_t stableId) const override;
    [[nodiscard]] Json tilesToJson(TilesId tiles) const override;
    Result<TilesId> tilesFromJson(const FieldInfo& field, const Json& json) override;
    [[nodiscard]] bool sameTiles(TilesId a, TilesId b) const override;
    void warn(Error error) override { warnings.push_back(std::move(error)); }

protected:
    World& world_;

private:
    mutable std::vector<std::pair<std::uint64_t, EntityId>> index_;  // sorted by stable id
    mutable bool indexed_ = false;
};

/// Returns the entity with this stable id, or the empty
/// handle. O(entities); use a WorldFieldContext for many.
Entity findById(World& world, std::uint64_t stableId);

}  // namespace plumb
