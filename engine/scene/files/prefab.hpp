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

/// One entity of a prefab, with everything that nested prefabs and overrides gave it.
struct PrefabEntity {
    std::uint64_t part = 0;    ///< its id inside the prefab; kRootPart for the first
    std::uint64_t parent = 0;  ///< the part it is a child of; 0 for the first
    std::string name;
    Json components = Json::object();  ///< references in them are parts
};

/// A prefab ready to be placed. The first entity is the root, parents stand before their children.
struct Prefab {
    static constexpr std::uint64_t kRootPart = 1;
    static constexpr int kFormat = 1;

    std::string path;
    std::vector<PrefabEntity> entities;
    std::vector<Error> problems;  ///< what was left out

    [[nodiscard]] const PrefabEntity* find(std::uint64_t part) const;
};

/// The id of a part of something that itself has an id: the same every time, so references to it last.
std::uint64_t combinedId(std::uint64_t outer, std::uint64_t part);

/// Reads the prefabs of a project, each once, with those inside them.
class PrefabLibrary {
public:
    explicit PrefabLibrary(const TypeRegistry& types, Path root = {})
        : types_{types}, root_{std::move(root)} {}

    /// Valid until this prefab, or one inside it, is forgotten.
    /// @error missing, unreadable, inside itself, nested too deep
    Result<const Prefab*> find(std::string_view path);

    /// Gives the text of a prefab in place of its file, e.g. while an editor changes it.
    void add(std::string_view path, std::string text);
    /// Reads all prefabs again when they are next asked for: what is inside others changes those too.
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
    std::vector<Source> given_;
    std::deque<Prefab> known_;  // a deque, so that pointers to it stay valid
};

/// Places a prefab that no scene file knows: enemies, bullets, coins made by the game. Not saved.
/// @return its root
/// @pre    the library knows the types of this world
Entity spawnPrefab(World& world, const TypeRegistry& types, const Prefab& prefab, Vec2 position);

/// Changes every reference to an entity in the JSON of components: `change(id)` gives the new id.
void changeReferences(const TypeRegistry& types, Json& components,
                      const std::function<std::uint64_t(std::uint64_t)>& change);

}  // namespace plumb
