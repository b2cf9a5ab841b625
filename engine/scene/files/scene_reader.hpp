#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "reflect/component_json.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/files/prefab_placing.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/files/world_field_context.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb {

/// Key in a scene that was converted from a prefab file for editing: records how the prefab file was written,
/// so that saving reproduces it. Kept and written back like unknown keys.
inline constexpr std::string_view kPrefabFileNote = "prefabFile";

/// Resolves references to entities of the scene that is being read, and records if one does not exist yet.
class ReadingContext final : public WorldFieldContext {
public:
    using WorldFieldContext::WorldFieldContext;

    [[nodiscard]] EntityId entity(std::uint64_t stableId) const override;
    bool insert(std::uint64_t stableId, EntityId entity) { return known_.emplace(stableId, entity).second; }
    void reserve(std::size_t count) { known_.reserve(count); }

    mutable bool missed = false;  ///< a requested entity did not exist yet

private:
    std::unordered_map<std::uint64_t, EntityId> known_;  // never iterated, so its order does not matter
};

/// Reads one scene into a world, entity by entity. Components that reference later entities are read in
/// finish().
class SceneReader {
public:
    SceneReader(World& world, const SceneContext& context, std::string_view path);

    void readEffects(const Json& json);
    void readLayers(const Json& json);
    void keepKey(std::string key, Json value);
    void reserve(std::size_t entities);
    /// @param place  index in the file's list of entities
    /// @param text   text of the entity in the file, kept if it cannot be loaded; empty for binary files
    void readEntity(Json json, int place, std::string_view text);
    void skipEntity(int place, std::string_view text, Error error);
    void problem(std::string where, std::string what, std::string remedy);
    /// Resolves references and parents, and adds the scene to LoadedScenes.
    LoadReport finish();

    int fileFormat = kSceneFormat;  ///< format number of the file that is read
    [[nodiscard]] const std::string& path() const { return scene_.path; }

private:
    struct DeferredComponent {  ///< a component that references a later entity
        EntityId entity;
        const TypeInfo* type;
        Json json;
        std::string where;
        std::uint64_t id;
    };
    struct ParentLink {  ///< a "parent" key, to resolve in finish()
        EntityId child;
        std::uint64_t id;
        Json parent;
        std::string where;
    };

    void readBackground(const Json& json);
    void checkEffects();
    void readNamedPrefabs();
    bool readId(const Json& json, int place, std::string_view text, std::uint64_t& id);
    bool placeInstance(const Json& json, int place, std::string_view text, std::uint64_t id,
                       EntityId& entity);
    void readKeys(const Json& json, EntityId entity, std::uint64_t id, const std::string& where);
    void readName(const Json& value, EntityId entity, std::uint64_t id, const std::string& where);
    void readWithout(const Json& value, EntityId entity, std::uint64_t id, const std::string& where);
    void readChildren(const Json& value, EntityId root, std::uint64_t id, const std::string& where);
    /// Reads the key "removed" of a part's overrides and destroys the part's entity if it is true.
    /// @return false if it was destroyed
    bool keepsPart(const Json& overrides, EntityId entity, std::uint64_t id, const std::string& where);
    void readComponents(const Json& value, EntityId entity, std::uint64_t id, const std::string& where);
    void readComponent(const TypeInfo& type, const Json& json, EntityId entity, std::uint64_t id,
                       const std::string& where, bool mayWait);
    void keepField(const TypeInfo& type, const std::string& key, const Json& json, const void* object,
                   std::uint64_t id);
    KeptEntity& kept(std::uint64_t id) { return rest_.entities[id]; }

    World& world_;
    const SceneContext& context_;
    ReadingContext fields_;
    LoadedScene scene_;
    SceneRest rest_;
    LoadReport report_;
    std::vector<DeferredComponent> deferred_;
    std::vector<ParentLink> parents_;
    std::vector<FieldProblem> fieldProblems_;
    std::vector<std::uint64_t> skippedIds_;
};

/// Converts an entity of an older format to the current one, format by format.
void migrateEntity(Json& entity, int format);

}  // namespace plumb
