#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/files/prefab_placing.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/files/world_field_context.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb {

/// Writes one scene of a world as text, entity by entity.
class SceneWriter {
public:
    /// The world is only read; it is not const because field contexts can also write to its stores.
    SceneWriter(World& world, const SceneContext& context, const LoadedScene& scene);

    std::string write();

private:
    struct Item {
        int order;
        std::uint64_t id;
        EntityId entity;
        const SkippedEntity* skipped;  ///< text to write instead of an entity; null: write `entity`
    };
    struct SavedType {
        const TypeInfo* type;
        PrefabValue defaults;
    };

    [[nodiscard]] std::vector<Item> itemsInOrder() const;
    [[nodiscard]] const KeptEntity* keptOf(std::uint64_t id) const;
    void addKeptFields(const TypeInfo& type, const void* object, const KeptEntity& kept, Json& fields) const;
    void addPosition(const TypeInfo& type, const void* transform, Json& fields) const;
    void addKeptKeys(const KeptEntity& kept, Json& json) const;
    void addName(EntityId entity, std::string_view inPrefab, const KeptEntity* kept, Json& json) const;
    Json entityToJson(const Item& item);
    /// @param base   the entity in its prefab; null if it does not belong to one
    /// @param parts  resolves references in `base`; null if `base` is null
    Json componentsOf(EntityId entity, const PrefabEntity* base, PartContext* parts,
                      const KeptEntity* kept) const;
    [[nodiscard]] Json withoutList(EntityId entity, const PrefabEntity& base) const;
    PlacedPrefab partsOf(EntityId root, std::uint64_t id, const Prefab& prefab);
    Json childrenOf(const Prefab& prefab, const PlacedPrefab& placed, PartContext& parts,
                    std::uint64_t id) const;
    [[nodiscard]] Json layersToJson() const;

    World& world_;
    const SceneContext& context_;
    const LoadedScene& scene_;
    WorldFieldContext fields_;
    std::vector<SavedType> savedTypes_;
    std::map<std::pair<std::uint64_t, std::uint64_t>, EntityId> partIndex_;  // key: ids of instance and part
};

}  // namespace plumb
