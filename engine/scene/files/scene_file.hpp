#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/random.hpp"
#include "core/result.hpp"
#include "ecs/entity.hpp"
#include "reflect/field_types.hpp"

namespace plumb {

class AssetStore;
class PrefabLibrary;
class TypeRegistry;
class World;

inline constexpr int kSceneFormat = 1;

/// Everything needed to read and write scenes.
struct SceneContext {
    const TypeRegistry& types;
    PrefabLibrary* prefabs = nullptr;  ///< null: prefab instances cannot be loaded
    Path root;                         ///< the project's folder, for the functions that access files
};

/// Result of loading a scene. Invalid parts listed in
/// `problems` are kept in the file when the scene is saved.
struct LoadReport {
    SceneId scene;
    std::size_t loaded = 0;   ///< number of entities loaded from the file
    std::size_t skipped = 0;  ///< number of invalid entities, kept as text only
    std::vector<Error> problems;
};

/// Adds a scene to a world, from the text of a `.scene.json` file. Invalid parts are skipped and reported.
/// @param path  the scene's path in the project, by which it is identified
/// @error       invalid JSON, not a scene, or a newer format; the world is unchanged
Result<LoadReport> loadScene(World& world, const SceneContext& context, std::string_view path,
                             std::string_view text);

/// Returns the `.scene.json` text of a scene in the world.
/// Reading a file and writing it again changes no byte.
std::string sceneToJson(const World& world, const SceneContext& context, SceneId scene);

/// Adds a scene to a world, from the content of a `.scene.bin` file: the same data as CBOR. See loadScene().
Result<LoadReport> loadSceneBinary(World& world, const SceneContext& context, std::string_view path,
                                   std::string_view bytes);
std::string sceneToBinary(const World& world, const SceneContext& context, SceneId scene);

/// Loads or saves a file below the context's root; names that end in `.bin` are binary. Loading also loads
/// the assets that the scene references if the world has an AssetStore.
Result<LoadReport> loadSceneFile(World& world, const SceneContext& context, std::string_view path);
Result<Done> saveSceneFile(const World& world, const SceneContext& context, std::string_view path);

/// Saves a scene to another path than it was loaded from; in the world it keeps the old path.
Result<Done> saveSceneFileAs(const World& world, const SceneContext& context, SceneId scene,
                             std::string_view path);

/// Adds an empty scene to the world, in which entities can be created and saved.
SceneId addScene(World& world, std::string_view path);

/// Creates an entity that belongs to a scene; it is saved as the last one in its file.
Entity createSceneEntity(World& world, SceneId scene, Random& ids);

/// Removes a scene and destroys its entities, except persistent ones and their children.
void unloadScene(World& world, SceneId scene);
/// Like unloadScene(), but destroys entities from last to first, which preserves the order of older entities.
void unloadOverlay(World& world, SceneId scene);
/// True if the entity or one of its ancestors is Persistent, so that it survives the unloading of its scene.
bool persists(const World& world, EntityId id);

/// Loads every asset that components reference.
void loadAssets(const World& world, const TypeRegistry& types, AssetStore& assets);

/// Returns a random stable id for an entity; never 0 or Prefab::kRootPart.
std::uint64_t newStableId(Random& random);

constexpr SceneId sceneId(std::string_view path) { return {textId(path)}; }

}  // namespace plumb
