#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
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

/// An asset that components of a prefab reference, or a prefab nested in it.
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
    int depth = 1;                    ///< levels of prefabs in it; 1 without nested prefabs
    // In its own file, not in those of nested prefabs.
    std::vector<Error> problems;  ///< entities and overrides that were skipped
    std::vector<Error> warnings;  ///< keys, components, fields and values that have no effect

    [[nodiscard]] const PrefabEntity* find(std::uint64_t part) const;
};

/// Returns the stable id of an entity of a prefab instance, computed from the id of the instance
/// (`outer`) and the id inside the prefab (`part`). Deterministic, so that references stay valid.
std::uint64_t combinedId(std::uint64_t outer, std::uint64_t part);

/// Reads, checks and caches the prefabs of a project, with the prefabs nested in them.
class PrefabLibrary {
public:
    explicit PrefabLibrary(const TypeRegistry& types, Path root = {})
        : types_{types}, root_{std::move(root)} {}

    /// Returns the prefab with this path; valid until add() or forget().
    /// @error the file is missing or unreadable, contains itself, or prefabs are nested too deeply
    Result<const Prefab*> find(std::string_view path);

    /// Returns the prefab for a name in code or scripts, see pathOf(); null if it cannot be read. Logs what
    /// is wrong, each problem once.
    const Prefab* named(std::string_view name);

    /// Returns the path for "coin", "coin.prefab.json", "prefabs/coin" or "prefabs/coin.prefab.json". A file
    /// without folder may be in the project's folder, in "prefabs" or in "assets".
    [[nodiscard]] std::string pathOf(std::string_view name) const;

    /// Reads these prefabs and those that their components name in turn. Missing files are passed over: the
    /// asset store reports them. @return those that could be read
    std::vector<const Prefab*> readAll(std::vector<std::string> paths);

    /// Returns the problems in the files that were read since the last call, so that each is reported once.
    std::vector<Error> takeProblems() { return std::exchange(problems_, {}); }

    /// Uses this text instead of the prefab's file, e.g. while an editor changes it.
    void add(std::string_view path, std::string text);
    /// All prefabs that were read and are cached.
    [[nodiscard]] const std::deque<Prefab>& known() const { return prefabs_; }
    /// After files of prefabs were changed: forget(), and logs what is wrong in these files. But if one of
    /// them or of the known prefabs cannot be read, all prefabs stay as they are until it can.
    void readAgain(const std::vector<std::string>& changed);
    /// Clears the cache, so all prefabs are read and checked again when
    /// needed: a changed prefab affects those that contain it.
    void forget();

private:
    struct Source {
        std::string path;
        std::string text;
    };
    struct Name {
        std::string name;
        const Prefab* prefab;
    };

    Result<const Prefab*> find(std::string_view path, std::vector<std::string>& open);
    Result<Prefab> read(std::string_view path, std::vector<std::string>& open);
    Result<std::string> textOf(std::string_view path);
    Error missing(std::string_view path);
    [[nodiscard]] bool has(std::string_view path) const;
    bool isNew(const Error& failure);

    const TypeRegistry& types_;
    Path root_;
    std::vector<Source> replacedTexts_;
    std::deque<Prefab> prefabs_;         // a deque, so that pointers to it stay valid
    std::vector<Name> names_;            // results of named()
    std::vector<Error> missing_;         // one for each missing file
    std::vector<Error> problems_;        // not taken yet
    std::vector<std::string> reported_;  // errors of prefabs that could not be read
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
