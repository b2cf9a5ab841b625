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

/// What reading and writing a scene needs to know.
struct SceneContext {
    const TypeRegistry& types;
    PrefabLibrary* prefabs = nullptr;  ///< none: instances of prefabs cannot be loaded
    Path root;                         ///< the project's folder, for the functions that take paths
};

/// What became of a file. Everything in `problems` stays in the file when the scene is saved.
struct LoadReport {
    SceneId scene;
    std::size_t loaded = 0;   ///< entities of the file
    std::size_t skipped = 0;  ///< entities that are kept as text only
    std::vector<Error> problems;
};

/// Adds a scene to a world, from the text of a `.scene.json`. What is broken is left out and reported.
/// @param path  the scene's name: its path in the project
/// @error       nothing can be loaded: no JSON, no scene, a newer format. The world is as before.
Result<LoadReport> loadScene(World& world, const SceneContext& context, std::string_view path,
                             std::string_view text);

/// The text of a scene that is loaded in the world. Reading and writing a file again changes no byte of it.
std::string sceneToJson(const World& world, const SceneContext& context, SceneId scene);

/// The same content as CBOR, the form of `.scene.bin`.
Result<LoadReport> loadSceneBinary(World& world, const SceneContext& context, std::string_view path,
                                   std::string_view bytes);
std::string sceneToBinary(const World& world, const SceneContext& context, SceneId scene);

/// Files below the context's root; names that end in `.bin` are binary. The assets that the scene names
/// are loaded too when the world was lent an AssetStore.
Result<LoadReport> loadSceneFile(World& world, const SceneContext& context, std::string_view path);
Result<Done> saveSceneFile(const World& world, const SceneContext& context, std::string_view path);

/// Saves under another name than the scene was loaded from; the world keeps the old one.
Result<Done> saveSceneFileAs(const World& world, const SceneContext& context, SceneId scene,
                             std::string_view path);

/// An empty scene, so that entities can be made in it and saved.
SceneId addScene(World& world, std::string_view path);

/// An entity that belongs to a scene and is saved with it, as its last one.
Entity createSceneEntity(World& world, SceneId scene, Random& ids);

/// Destroys the scene's entities, but for the persistent ones and their children, and forgets its file.
void unloadScene(World& world, SceneId scene);
/// The same from the last entity to the first, which leaves the order of those made before as it was.
void unloadOverlay(World& world, SceneId scene);
/// Whether an entity, or one that it is a child of, stays when its scene goes.
bool persists(const World& world, EntityId id);

/// Loads every asset that components name.
void loadAssets(const World& world, const TypeRegistry& types, AssetStore& assets);

/// A random id for an entity; never 0.
std::uint64_t newStableId(Random& random);

constexpr SceneId sceneId(std::string_view path) { return {textId(path)}; }

}  // namespace plumb
