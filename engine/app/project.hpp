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

/// What project.json says: the settings that all scenes of a game share.
struct Project {
    Path root;  ///< the folder; nothing outside it is read or written
    std::string name = "Untitled";
    std::string version = "0.1.0";
    std::string startScene;  ///< "scenes/title.scene.json"
    std::string pauseScene;  ///< the overlay that the Pause action opens during play; empty for none
    int windowWidth = 1280;  ///< px
    int windowHeight = 720;  ///< px
    bool fullscreen = false;
    int width = 1280;  ///< px of the game's own picture
    int height = 720;  ///< px
    WindowScale scaling = WindowScale::Fit;
    bool smooth = false;           ///< pictures and edges are smoothed: for drawings, not for pixel art
    Vec2 gravity{0.0f, 980.0f};    ///< px/s²
    float pixelsPerMetre = 64.0f;  ///< px in a metre of the physics
    int physicsQuality = 2;  ///< 2^quality substeps in a tick; scenes, bodies and joints may say otherwise
    std::vector<std::string> layers;  ///< names of the layers of collisions, from the lowest bit on
    ActionMap actions;
    std::vector<Error> warnings;  ///< what was wrong, and what was used instead
};

/// @param path  the project's folder, or its project.json
/// @error no such project, or a project.json that is no JSON object; smaller faults become warnings
Result<Project> loadProject(const Path& path);

/// The same from text. `where` names it in messages.
Result<Project> projectFromText(std::string_view text, const Path& root, const std::string& where);

/// "level1", "level1.scene.json" or "scenes/level1.scene.json": the scene's path in the project.
std::string scenePath(std::string_view name);

}  // namespace plumb
