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

/// Problems of a project, and the number of files checked.
struct ProjectCheck {
    std::vector<Error> problems;  ///< without duplicates; first the warnings
    std::size_t warnings = 0;  ///< of the problems: settings in project.json that are replaced by the default
    std::size_t scenes = 0;
    std::size_t prefabs = 0;
    std::size_t assets = 0;

    [[nodiscard]] std::size_t errors() const { return problems.size() - warnings; }
    /// Returns one line per problem, and a last line with counts.
    [[nodiscard]] std::string text() const;
};

/// Opens every scene and prefab of a project and loads every asset. Leaves the last scene open.
ProjectCheck checkProject(const Project& project, Workspace& workspace, PrefabLibrary& prefabs);

}  // namespace plumb::editor
