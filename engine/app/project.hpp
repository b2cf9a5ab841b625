#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "input/action_map.hpp"
#include "math/vec2.hpp"
#include "render/view.hpp"

namespace plumb {

/// Content of project.json: settings that all scenes of a game share.
struct Project {
    Path root;  ///< the project's folder; no file outside it is read or written
    std::string name = "Untitled";
    std::string version = "0.1.0";
    std::string startScene;  ///< path of the first scene, e.g. "scenes/title.scene.json"
    std::string pauseScene;  ///< path of the overlay that the Pause action opens; empty for none
    int windowWidth = 1280;  ///< px
    int windowHeight = 720;  ///< px
    bool fullscreen = false;
    int width = 1280;  ///< px, width of the game image
    int height = 720;  ///< px, height of the game image
    WindowScale scaling = WindowScale::Fit;
    bool smooth = false;           ///< linear texture filter and antialiasing: not for pixel art
    Vec2 gravity{0.0f, 980.0f};    ///< px/s²
    float pixelsPerMetre = 64.0f;  ///< px per metre of the physics
    int physicsQuality = 2;        ///< 2^quality substeps per tick; scenes, bodies and joints may override it
    std::string icon;   ///< path of the PNG file that an exported page has as its icon; empty: none
    bool mods = false;  ///< files beside the pack of an exported game replace those in it
    std::vector<std::string> leftOut;  ///< starts of paths that exports leave out, e.g. "art/"
    std::vector<std::string> layers;   ///< names of the collision layers, from the lowest bit
    ActionMap actions;
    std::vector<Error> warnings;  ///< errors in the file, and the values used instead
};

/// Loads a project.
/// @param path  path of the project's folder or of its project.json
/// @error there is no such project, or project.json is not a JSON object; other errors become warnings
Result<Project> loadProject(const Path& path);

/// Reads a project from the text of its project.json. @param where  name of the text in error messages
Result<Project> projectFromText(std::string_view text, const Path& root, const std::string& where);

}  // namespace plumb
