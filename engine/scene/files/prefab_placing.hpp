#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecs/world.hpp"
#include "reflect/json_fwd.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/world_field_context.hpp"

namespace plumb {

/// The entities of a prefab instance, in the order of Prefab::entities.
struct PlacedPrefab {
    std::vector<EntityId> entities;
};

/// Resolves references to parts of one prefab instance; other references are resolved in the world.
class PartContext final : public WorldFieldContext {
public:
    PartContext(World& world, const Prefab& prefab, const PlacedPrefab& placed)
        : WorldFieldContext{world}, prefab_{prefab}, placed_{placed} {}

    [[nodiscard]] EntityId entity(std::uint64_t part) const override;

private:
    const Prefab& prefab_;
    const PlacedPrefab& placed_;
};

/// Creates the entities of a prefab with their names, parents and components.
PlacedPrefab placePrefab(World& world, const TypeRegistry& types, const Prefab& prefab);

/// The value of a component in a prefab, before the overrides of an instance. Owns its memory.
class PrefabValue {
public:
    /// @param fields  the component's JSON in the prefab; null for the type's defaults
    PrefabValue(const TypeInfo& type, const Json* fields, FieldContext& context);

    [[nodiscard]] const void* get() const { return memory_.data(); }

private:
    std::vector<std::max_align_t> memory_;
};

}  // namespace plumb
