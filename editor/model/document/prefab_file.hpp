#pragma once

#include <string>
#include <string_view>

#include "core/file.hpp"
#include "ecs/world.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb::editor {

// A prefab's file is edited as a scene, in which its first entity is the root with the id Prefab::kRootPart.
// loadFileText and fileText convert between the two file formats; all other code sees a Document.

/// True if the path is that of a prefab file.
bool isPrefabFile(std::string_view path);

/// Loads a scene or prefab into a world from the text of its file. @param path  decides the format
Result<LoadReport> loadFileText(World& world, const SceneContext& context, std::string_view path,
                                std::string_view text);

/// Loads a scene or prefab file into a world, and the assets that it references.
/// @param text  used instead of the file's content if not null
Result<LoadReport> readFileText(World& world, const SceneContext& context, const std::string& path,
                                const std::string* text);

/// Saves the prefab that is loaded in a world.
/// @error  it could not be loaded again, so it is not written; or writing failed
Result<Done> savePrefab(const World& world, const SceneContext& context, SceneId scene,
                        const std::string& path);

/// Returns the file text of a scene or prefab loaded in a world. Loading and saving a file does not change a
/// byte of it. A prefab's file has the position and rotation of its root only if it had them before.
std::string fileText(const World& world, const SceneContext& context, SceneId scene);

/// True if `prefab` is `outer` or is nested in it at any depth. @param root  the project's folder
bool isInside(const Path& root, std::string_view prefab, std::string_view outer);

}  // namespace plumb::editor
