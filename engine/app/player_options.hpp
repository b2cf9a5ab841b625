#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "platform/window.hpp"
#include "scene/drawing/physics_view.hpp"

namespace plumb {

/// What a person asked the player for on its command line.
struct PlayerOptions {
    std::string project = "projects/platformer";
    std::string scene;           ///< empty: the project's start scene
    bool headless = false;       ///< no window, no GL, no audio
    std::int64_t frames = -1;    ///< ticks to play; -1 until closed
    bool hash = false;           ///< print `hash: …` of the whole state last
    std::int64_t hashEvery = 0;  ///< print it every so many ticks
    std::string screenshot;      ///< PNG of the last frame
    std::string capture;         ///< folder for a PNG of every frame
    std::string record;
    std::string replay;
    bool allEffects = false;  ///< all run, also those that no component calls for
    bool effects = false;     ///< list what the scene calls for, and what it costs
    bool benchmark = false;
    int entities = 0;  ///< of the benchmark; 0: as many as the seed's table has
    std::uint64_t seed = 1;
    int scale = 0;     ///< window size in multiples of the game's resolution; 0: the project's window
    int threads = 0;   ///< of the physics; 0: as many as pay
    PixelSize window;  ///< px; nothing: the project's window
    bool fullscreen = false;
    PhysicsView physicsView;  ///< what of the physics is shown over the game
    bool help = false;
};

/// @error an unknown option, a missing or wrong value; the remedy names the closest option
Result<PlayerOptions> parsePlayerOptions(std::span<const char* const> arguments);

std::string playerUsage();

/// Those of a game in code: all but the options that are about scenes and projects.
/// @error as parsePlayerOptions; a word that belongs to no option
Result<PlayerOptions> parseGameOptions(std::span<const char* const> arguments);

/// @param program  its name
std::string gameUsage(std::string_view program);

}  // namespace plumb
