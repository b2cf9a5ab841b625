#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecs/world.hpp"
#include "reflect/json_fwd.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/world_field_context.hpp"

namespace plumb {

/// The entities that a prefab became, in the order of Prefab::entities.
struct PlacedPrefab {
    std::vector<EntityId> entities;
};

/// Answers references to parts of one placed prefab, and asks the world for all others.
class PartContext final : public WorldFieldContext {
public:
    PartContext(World& world, const Prefab& prefab, const PlacedPrefab& placed)
        : WorldFieldContext{world}, prefab_{prefab}, placed_{placed} {}

    [[nodiscard]] EntityId entity(std::uint64_t part) const override;

private:
    const Prefab& prefab_;
    const PlacedPrefab& placed_;
};

/// Makes the entities with their names, parents and components, all as the prefab says.
PlacedPrefab placePrefab(World& world, const TypeRegistry& types, const Prefab& prefab);

/// The value that a component of a prefab's entity has before overrides, in memory of its own.
class PrefabValue {
public:
    /// @param fields  the component's JSON in the prefab; null for the type's defaults
    PrefabValue(const TypeInfo& type, const Json* fields, FieldContext& context);

    [[nodiscard]] const void* get() const { return memory_.data(); }

private:
    std::vector<std::max_align_t> memory_;
};

}  // namespace plumb
