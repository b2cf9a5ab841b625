#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/file.hpp"

namespace plumb::editor {

/// What a new project begins with.
struct ProjectTemplate {
    std::string_view id;
    std::string_view name;
    std::string_view what;    ///< in one line
    std::string_view copyOf;  ///< folder below the engine's projects; empty: made from nothing
    std::string_view start;   ///< folder below assets/templates: it has this project file and these scenes
                              ///< instead of those of the project that is copied; empty: it keeps its own
};

std::span<const ProjectTemplate> projectTemplates();

/// Where the projects are that come with the engine; empty when they are not here.
Path engineProjects();

/// Whether what a template is made from came with this program.
bool isHere(const ProjectTemplate& row);

/// A name of a folder for a name that a person wrote: "My Game" becomes "my-game".
std::string folderNameFor(std::string_view name);

/// Makes a project in a folder that is not there yet, or is empty. Nothing that is there is written over.
/// @return its folder
/// @error  no name, a folder with something in it, one that cannot be written, a template that is not here
Result<Path> createProject(const ProjectTemplate& from, std::string_view name, const Path& folder);

/// Whether there is a project.json in it.
bool isProject(const Path& folder);
/// What a project calls itself; the name of its folder when it does not say.
std::string projectNameOf(const Path& folder);

/// The picture of a project for lists, taken when it was open last.
Path projectPicture(const Path& folder);

}  // namespace plumb::editor
