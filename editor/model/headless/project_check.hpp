#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace plumb {
struct Project;
class PrefabLibrary;
}  // namespace plumb

namespace plumb::editor {

class Workspace;

/// What is wrong with a project, and how much was looked at.
struct ProjectCheck {
    std::vector<Error> problems;  ///< each once
    std::size_t scenes = 0;
    std::size_t prefabs = 0;
    std::size_t assets = 0;
    bool playable = true;  ///< every scene can be read at all

    /// One line for each problem, and a last one that counts.
    [[nodiscard]] std::string text() const;
};

/// Opens every scene and prefab of a project and loads every asset. Afterwards some scene is open.
ProjectCheck checkProject(const Project& project, Workspace& workspace, PrefabLibrary& prefabs);

}  // namespace plumb::editor
