#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "ecs/entity.hpp"
#include "math/vec2.hpp"
#include "reflect/field_types.hpp"
#include "reflect/json.hpp"

namespace plumb {

class TypeRegistry;
class World;

/// One entity of a prefab, with nested prefabs and overrides applied.
struct PrefabEntity {
    std::uint64_t part = 0;    ///< id inside the prefab; kRootPart for the root
    std::uint64_t parent = 0;  ///< id of the parent part; 0 for the root
    std::string name;
    Json components = Json::object();  ///< references to entities are ids of parts
};

/// An asset that components of a prefab reference.
struct PrefabAsset {
    AssetKind kind = AssetKind::None;
    std::string path;

    friend bool operator==(const PrefabAsset&, const PrefabAsset&) = default;
};

/// A prefab ready to be instantiated. The first entity is the root; parents come before their children.
struct Prefab {
    static constexpr std::uint64_t kRootPart = 1;
    static constexpr int kFormat = 1;

    std::string path;
    std::vector<PrefabEntity> entities;
    std::vector<PrefabAsset> assets;  ///< without duplicates
    std::vector<Error> problems;      ///< errors of the entities that were skipped

    [[nodiscard]] const PrefabEntity* find(std::uint64_t part) const;
};

/// Returns the stable id of an entity of a prefab instance, computed from the id of the instance
/// (`outer`) and the id inside the prefab (`part`). Deterministic, so that references stay valid.
std::uint64_t combinedId(std::uint64_t outer, std::uint64_t part);

/// Reads and caches the prefabs of a project, with the prefabs nested in them.
class PrefabLibrary {
public:
    explicit PrefabLibrary(const TypeRegistry& types, Path root = {})
        : types_{types}, root_{std::move(root)} {}

    /// Returns the prefab with this path; valid until add() or forget().
    /// @error the file is missing or unreadable, contains itself, or prefabs are nested too deeply
    Result<const Prefab*> find(std::string_view path);

    /// Uses this text instead of the prefab's file, e.g. while an editor changes it.
    void add(std::string_view path, std::string text);
    /// Clears the cache, so all prefabs are read again when
    /// needed: a changed prefab affects those that contain it.
    void forget();

private:
    struct Source {
        std::string path;
        std::string text;
    };

    Result<Prefab> read(std::string_view path, std::vector<std::string>& open);
    Result<std::string> textOf(std::string_view path) const;

    const TypeRegistry& types_;
    Path root_;
    std::vector<Source> replacedTexts_;
    std::deque<Prefab> prefabs_;  // a deque, so that pointers to it stay valid
};

/// Instantiates a prefab at runtime: enemies, bullets,
/// coins. The entities belong to no scene and are not saved.
/// @param position  px, of the root
/// @return the root entity
/// @pre    the prefab was read with the types of this world
Entity spawnPrefab(World& world, const TypeRegistry& types, const Prefab& prefab, Vec2 position);

/// Replaces every reference to an entity in the JSON of components; `change(id)` returns the new id.
void changeReferences(const TypeRegistry& types, Json& components,
                      const std::function<std::uint64_t(std::uint64_t)>& change);

}  // namespace plumb
