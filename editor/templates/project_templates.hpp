#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/file.hpp"

namespace plumb::editor {

/// A template for new projects.
struct ProjectTemplate {
    std::string_view id;
    std::string_view name;
    std::string_view what;    ///< description, one line of the welcome screen
    std::string_view copyOf;  ///< folder of the project to copy, below `engineProjects`; empty: none
    std::string_view start;   ///< folder below assets/templates whose project file and scenes replace
                              ///< those of the copied project; empty: those are kept
    std::span<const std::string_view> assets = {};  ///< files that are copied from the folder `assets` of
                                                    ///< the project; empty: the whole project is
};

/// All templates.
std::span<const ProjectTemplate> projectTemplates();

/// Returns the template with this id, or null.
const ProjectTemplate* findTemplate(std::string_view id);

/// Returns the folder of the projects that come with the engine; empty if it is not installed.
Path engineProjects();

/// True if the folders that the template copies are installed with this program.
bool isHere(const ProjectTemplate& row);

/// Returns a folder name for a project name: "My Game" becomes "my-game".
std::string folderNameFor(std::string_view name);

/// Creates a project in a new or empty folder. Existing files are never overwritten.
/// @return the folder of the project
/// @error  empty name, folder not empty or not writable, or template not installed
Result<Path> createProject(const ProjectTemplate& from, std::string_view name, const Path& folder);

/// True if the folder contains a project.json.
bool isProject(const Path& folder);
/// Returns the "name" in the project's file; the name of the folder if there is none.
std::string projectNameOf(const Path& folder);

/// Returns the path of the project's preview image, taken when the project was last open.
Path projectPicture(const Path& folder);

}  // namespace plumb::editor
