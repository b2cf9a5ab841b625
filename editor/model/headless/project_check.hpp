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
    std::vector<Error> problems;  ///< without duplicates
    std::size_t scenes = 0;
    std::size_t prefabs = 0;
    std::size_t assets = 0;
    bool playable = true;  ///< the code and all scenes can be read, and the start scene exists

    /// Returns one line per problem, and a last line with counts.
    [[nodiscard]] std::string text() const;
};

/// Opens every scene and prefab of a project and loads every asset. Leaves the last scene open.
ProjectCheck checkProject(const Project& project, Workspace& workspace, PrefabLibrary& prefabs);

}  // namespace plumb::editor
