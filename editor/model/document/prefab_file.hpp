#pragma once

#include <string>
#include <string_view>

#include "core/file.hpp"
#include "ecs/world.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb::editor {

// The file of a prefab is edited as a scene: its first entity has the id Prefab::kRootPart there, all others
// are below it. These two know the difference between both kinds of files; all else has a document.

/// Whether a path is that of a prefab.
bool isPrefabFile(std::string_view path);

/// Adds a file to a world, from its text. @param path  of a scene or a prefab
Result<LoadReport> loadFileText(World& world, const SceneContext& context, std::string_view path,
                                std::string_view text);

/// The same from the file itself, or with a text in its place; the assets that it names are loaded too.
/// @param text  null: the file's
Result<LoadReport> readFileText(World& world, const SceneContext& context, const std::string& path,
                                const std::string* text);

/// Writes a prefab that is loaded in a world. @error  it could not be read again, so nothing is written
Result<Done> savePrefab(const World& world, const SceneContext& context, SceneId scene,
                        const std::string& path);

/// The file of what is loaded in a world. Reading and writing a file again changes no byte of it. Where the
/// first entity of a prefab stands and how it is turned is no part of it, unless the file said so before.
std::string fileText(const World& world, const SceneContext& context, SceneId scene);

/// Whether a prefab is another one, or lies somewhere inside of it. @param root  the project's folder
bool isInside(const Path& root, std::string_view prefab, std::string_view outer);

}  // namespace plumb::editor
