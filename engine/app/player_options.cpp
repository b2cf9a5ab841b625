#include "app/player_options.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/option_rows.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::int64_t kLargestWindow = 16384;  ///< px, maximum side of a window
constexpr std::int64_t kMaxThreads = 64;

using Row = OptionRow<PlayerOptions>;

bool setNumber(std::string_view text, std::int64_t least, std::int64_t& number) {
    const auto value = parseInt(text);
    if (!value || *value < least) return false;
    number = *value;
    return true;
}

bool setSeed(PlayerOptions& options, std::string_view text) {
    std::int64_t seed = 0;
    if (!setNumber(text, 0, seed)) return false;
    options.seed = static_cast<std::uint64_t>(seed);
    return true;
}

bool setScale(PlayerOptions& options, std::string_view text) {
    std::int64_t scale = 0;
    if (!setNumber(text, 1, scale) || scale > 16) return false;
    options.scale = static_cast<int>(scale);
    return true;
}

bool setEntities(PlayerOptions& options, std::string_view text) {
    std::int64_t entities = 0;
    if (!setNumber(text, 1, entities) || entities > 1'000'000) return false;
    options.entities = static_cast<int>(entities);
    return true;
}

bool setThreads(PlayerOptions& options, std::string_view text) {
    std::int64_t threads = 0;
    if (!setNumber(text, 1, threads) || threads > kMaxThreads) return false;
    options.threads = static_cast<int>(threads);
    return true;
}

bool setWindow(PlayerOptions& options, std::string_view text) {
    const std::size_t cross = text.find('x');
    std::int64_t width = 0;
    std::int64_t height = 0;
    if (cross == std::string_view::npos || !setNumber(text.substr(0, cross), 1, width) ||
        !setNumber(text.substr(cross + 1), 1, height) || width > kLargestWindow || height > kLargestWindow)
        return false;
    options.window = {static_cast<int>(width), static_cast<int>(height)};
    return true;
}

bool setPhysicsView(PlayerOptions& options, std::string_view text) {
    const Result<unsigned> layers = physicsLayersNamed(text);
    if (!layers || *layers == 0) return false;
    options.physicsView.on = true;
    options.physicsView.layers = *layers;
    return true;
}

/// Options of every game.
constexpr std::array kGameOptions{
    Row{"--headless", "", "no window, OpenGL or audio; run as fast as possible",
        [](PlayerOptions& o, std::string_view) { return o.headless = true; }},
    Row{"--frames", "N", "stop after N ticks; with --benchmark: measure N frames",
        [](PlayerOptions& o, std::string_view v) { return setNumber(v, 0, o.frames); }},
    Row{"--hash", "", "print the hash of the whole simulation state at the end",
        [](PlayerOptions& o, std::string_view) { return o.hash = true; }},
    Row{"--hash-every", "N", "print the hash every N ticks",
        [](PlayerOptions& o, std::string_view v) { return setNumber(v, 1, o.hashEvery); }},
    Row{"--screenshot", "FILE.png", "save the last frame as a PNG image; no other format",
        [](PlayerOptions& o, std::string_view v) { return setPngPath(v, o.screenshot); }},
    Row{"--capture", "DIR", "save every frame as PNG in this folder",
        [](PlayerOptions& o, std::string_view v) { return setText(v, o.capture); }},
    Row{"--record", "FILE", "record the input to a file, up to a crash too",
        [](PlayerOptions& o, std::string_view v) { return setText(v, o.record); }},
    Row{"--replay", "FILE", "replay recorded input, with its scene and seed",
        [](PlayerOptions& o, std::string_view v) { return setText(v, o.replay); }},
    Row{"--crash-reports", "DIR",
        "write a replay to this folder if the game crashes; default: the game's data folder if it is played "
        "in a window",
        [](PlayerOptions& o, std::string_view v) { return setText(v, o.crashReports); }},
    Row{"--link", "TEXT",
        "replay a link, #r=... or an address that ends in it; in a window, any key takes over",
        [](PlayerOptions& o, std::string_view v) { return setText(v, o.link); }},
    Row{"--print-link", "", "print a link that replays the run, at the end",
        [](PlayerOptions& o, std::string_view) { return o.printLink = true; }},
    Row{"--saves", "DIR", "folder of saved games and settings; default: the system's folder for them",
        [](PlayerOptions& o, std::string_view v) { return setText(v, o.saves); }},
    Row{"--safe", "", "start without the settings of the player",
        [](PlayerOptions& o, std::string_view) { return o.safe = true; }},
    Row{"--all-effects", "", "run all features of the engine (effects), requested or not",
        [](PlayerOptions& o, std::string_view) { return o.allEffects = true; }},
    Row{"--seed", "N", "seed of the game's random numbers", &setSeed},
    Row{"--threads", "N", "number of physics threads, 1..64; default: as many as the machine has, up to 8",
        &setThreads},
    Row{"--scale", "N", "window size in multiples of the game's resolution, 1..16", &setScale},
    Row{"--window", "WxH", "window size in px, e.g. 1280x720", &setWindow},
    Row{"--fullscreen", "", "start in fullscreen mode",
        [](PlayerOptions& o, std::string_view) { return o.fullscreen = true; }},
    Row{"--physics-view", "LIST",
        "show physics layers (F3; Ctrl+digit and Ctrl+Shift+digit toggle them): all, or some of "
        "shapes,contacts,normals,impulses,friction,joints,jointForces,velocities,centres,islands,triggers,"
        "fields,sleep,sweeps,bounds,broadPhase,paths,times,counts",
        &setPhysicsView},
    Row{"--help", "", "print this help", [](PlayerOptions& o, std::string_view) { return o.help = true; }},
};

/// Options of the player, which plays projects.
constexpr std::array kProjectOptions{
    Row{"--scene", "NAME", "start with this scene",
        [](PlayerOptions& o, std::string_view v) { return setText(v, o.scene); }},
    Row{"--effects", "", "list the features (effects) that the scene requests, and their cost",
        [](PlayerOptions& o, std::string_view) { return o.effects = true; }},
    Row{"--benchmark", "", "measure 10,000 moving, colliding, drawn entities",
        [](PlayerOptions& o, std::string_view) { return o.benchmark = true; }},
    Row{"--entities", "N", "number of entities in the benchmark, 1..1000000", &setEntities},
};

constexpr auto kPlayerOptions = [] {
    std::array<Row, kProjectOptions.size() + kGameOptions.size()> all{};
    std::copy(kGameOptions.begin(), kGameOptions.end(),
              std::copy(kProjectOptions.begin(), kProjectOptions.end(), all.begin()));
    return all;
}();

/// Fails for --headless with an option that needs rendered frames, and for a replay or a recording with one
/// that would make the game another one than the recorded one.
Result<Done> checkTogether(const PlayerOptions& options) {
    const char* drawn = !options.screenshot.empty() ? "--screenshot"
                        : !options.capture.empty()  ? "--capture"
                        : options.physicsView.on    ? "--physics-view"
                                                    : nullptr;
    if (options.headless && drawn != nullptr)
        return Error{"command line", format("{} needs rendered frames, but --headless renders none", drawn),
                     "leave out --headless: without a display the game renders offscreen"};
    struct Refused {
        bool given;
        std::string_view name;
        std::string_view why;
        bool inRecordings = false;  ///< refused with --record, too
    };
    const std::array refused{
        Refused{!options.replay.empty() && !options.link.empty(), "--replay", "only one run can be replayed"},
        Refused{!options.scene.empty(), "--scene", "a replay begins with the scene that was recorded"},
        Refused{options.seed.has_value(), "--seed", "a replay uses the seed that was recorded"},
        Refused{options.effects, "--effects", "it plays without input"},
        Refused{options.benchmark, "--benchmark", "it plays no project"},
        Refused{options.allEffects, "--all-effects",
                "which effects run is part of the state, so every hash differs, even where results do not",
                true},
    };
    for (const auto& [given, name, why, inRecordings] : refused) {
        const char* with = !options.link.empty()                           ? "--link"
                           : !options.replay.empty()                       ? "--replay"
                           : inRecordings && !options.record.empty()       ? "--record"
                           : inRecordings && options.printLink             ? "--print-link"
                           : inRecordings && !options.crashReports.empty() ? "--crash-reports"
                                                                           : nullptr;
        if (given && with != nullptr)
            return Error{"command line", format("{} cannot be used with {}: {}", name, with, why),
                         format("leave out {} or {}", name, with)};
    }
    return Done{};
}

}  // namespace

Result<PlayerOptions> parsePlayerOptions(std::span<const char* const> arguments) {
    PlayerOptions options;
    bool hasProject = false;
    const Result<Done> read = readOptions<
        PlayerOptions>(kPlayerOptions, arguments, options, [&](std::string_view word) -> Result<Done> {
        if (hasProject)
            return Error{"command line", format("\"{}\" is a second project", word), "give only one project"};
        options.project = word;
        hasProject = true;
        return Done{};
    });
    if (!read) return read.error();
    if (const Result<Done> fits = checkTogether(options); !fits) return fits.error();
    return options;
}

std::string playerUsage() {
    return "usage: plumb-player [PROJECT] [options]\n\n" + optionLines(helpOf<PlayerOptions>(kPlayerOptions));
}

Result<PlayerOptions> parseGameOptions(std::span<const char* const> arguments) {
    PlayerOptions options;
    const Result<Done> read = readOptions<PlayerOptions>(
        kGameOptions, arguments, options, [](std::string_view word) -> Result<Done> {
            return Error{"command line", format("\"{}\" is not an option", word),
                         "run with --help to list the options"};
        });
    if (!read) return read.error();
    if (const Result<Done> fits = checkTogether(options); !fits) return fits.error();
    return options;
}

std::string gameUsage(std::string_view program) {
    return format("usage: {} [options]\n\n", program) + optionLines(helpOf<PlayerOptions>(kGameOptions));
}

}  // namespace plumb
