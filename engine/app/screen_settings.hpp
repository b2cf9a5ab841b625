#pragma once

#include <string>

#include "app/player_options.hpp"
#include "math/vec2.hpp"
#include "render/view.hpp"

namespace plumb {

/// The window of a game and the image in it: what project.json says for a game of scenes.
struct ScreenSettings {
    std::string title = "Plumb";
    int windowWidth = 1280;  ///< px
    int windowHeight = 720;  ///< px
    bool fullscreen = false;
    Vec2 picture{1280.0f, 720.0f};  ///< px, size of the game image, which is scaled to the window
    WindowScale scaling = WindowScale::Fit;
    bool smooth = false;  ///< linear texture filter and antialiasing: not for pixel art
    /// px, size of the window without the settings of the player; 0: windowWidth, windowHeight
    int standardWidth = 0, standardHeight = 0;
    bool standardFullscreen = false;  ///< fullscreen without the settings of the player
};

/// Returns the settings with those of the command line, which override them: --scale, --window, --fullscreen.
ScreenSettings withOptions(ScreenSettings settings, const PlayerOptions& options);

}  // namespace plumb
