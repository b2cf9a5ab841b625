#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "platform/window.hpp"
#include "scene/drawing/physics_view.hpp"

namespace plumb {

/// Command line options of the player.
struct PlayerOptions {
    std::string project;         ///< folder; empty: the game beside the program, or else a sample
    std::string exportedAs;      ///< name of the program of an export; empty: the player as it was built
    std::string scene;           ///< empty: the project's start scene
    bool headless = false;       ///< no window, OpenGL or audio
    std::int64_t frames = -1;    ///< number of ticks to play; -1: until closed
    bool hash = false;           ///< print `hash: …` of the simulation state at the end
    std::int64_t hashEvery = 0;  ///< print the hash every this many ticks; 0: never
    std::string screenshot;      ///< path of a PNG file for the last frame
    std::string capture;         ///< folder for PNG files of every frame
    std::string record;          ///< path of a file to record input to
    std::string replay;          ///< path of a file to replay input from
    std::string crashReports;    ///< folder for reports of crashes; empty: see GameLoop
    std::string link;            ///< link to replay, see input/replay_link.hpp
    bool printLink = false;      ///< print a link that replays the run at the end
    std::string saves;           ///< folder of saved games and settings; empty: that of the system
    bool safe = false;           ///< without the settings of the player
    bool allEffects = false;     ///< run all effects (features of the engine), requested or not
    bool effects = false;        ///< list the effects of the scene and their cost
    bool benchmark = false;      ///< run the benchmark instead of a project
    int entities = 0;            ///< number of entities of the benchmark; 0: default
    std::optional<std::uint64_t> seed;  ///< seed of the game's random numbers; see seedOf()
    int scale = 0;     ///< window size in multiples of the game resolution; 0: the project's window size
    int threads = 0;   ///< threads of the physics; 0: automatic
    PixelSize window;  ///< px, window size; empty: the project's window size
    bool fullscreen = false;
    PhysicsView physicsView;  ///< physics debug view shown over the game
    bool help = false;
};

/// Returns the seed of the game's random numbers: 1 if the options contain none; see begun().
inline std::uint64_t seedOf(const PlayerOptions& options) { return options.seed.value_or(1); }

/// Parses the options of plumb-player.
/// @error an unknown option, the remedy suggests the closest one; a missing or invalid value; options that
/// contradict each other
Result<PlayerOptions> parsePlayerOptions(std::span<const char* const> arguments);

/// Returns the help text of plumb-player.
std::string playerUsage();

/// Parses the options of a game in code: all except those about scenes and projects.
/// @error as parsePlayerOptions(); also an argument that belongs to no option
Result<PlayerOptions> parseGameOptions(std::span<const char* const> arguments);

/// Returns the help text of a game in code. @param program  name of the program
std::string gameUsage(std::string_view program);

}  // namespace plumb
