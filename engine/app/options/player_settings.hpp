#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "input/action_map.hpp"

namespace plumb {

/// What the player of a game has chosen, in `settings.json` of the game's folder. Nothing of it changes the
/// simulation.
struct PlayerSettings {
    static constexpr int kMostScale = 8;

    bool fullscreen = false;
    int scale = 0;      ///< size of the window in multiples of the game's resolution; 0: that of the project
    bool vsync = true;  ///< wait for the display before a frame is shown
    int frameCap = 0;   ///< Hz, 0: automatic: FramePacer::rest()
    float master = 1.0f;  ///< volume of everything, ratio, 0..1
    float music = 1.0f;   ///< volume of the music, ratio, 0..1
    float sounds = 1.0f;  ///< volume of the other sounds, ratio, 0..1
    ActionMap keys;       ///< all bindings: those of the project with the changes of the player

    friend bool operator==(const PlayerSettings&, const PlayerSettings&) = default;
};

/// Reads settings on top of those of the project: a wrong value is reported, and the project's is used.
/// @param where  name of the text, for messages
PlayerSettings settingsFromText(std::string_view text, const PlayerSettings& project,
                                const std::string& where, std::vector<Error>& warnings);

/// Returns the text of the file, with the keys that differ from the project's.
std::string settingsText(const PlayerSettings& settings, const PlayerSettings& project);

/// Reads the file of a game's folder. Without a file the settings are those of the project.
/// @param warnings  receives what could not be read
PlayerSettings readSettings(const Path& file, const PlayerSettings& project, std::vector<Error>& warnings);

/// Replaces the file.
/// @param keeps  keep the present file, as `settings.old.json` beside it
/// @error the file cannot be written; it is what it was before
Result<Done> writeSettings(const Path& file, std::string_view text, bool keeps);

}  // namespace plumb
