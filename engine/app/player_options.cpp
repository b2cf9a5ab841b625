#include "app/player_options.hpp"

#include <array>
#include <string_view>
#include <vector>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::int64_t kLargestWindow = 16384;  ///< px a side

struct Option {
    std::string_view name;
    std::string_view value;  ///< what to write behind it; empty for a switch
    std::string_view doc;
    bool (*set)(PlayerOptions& options, std::string_view value);  ///< false when the value is wrong
};

bool setNumber(std::string_view text, std::int64_t least, std::int64_t& number) {
    const auto value = parseInt(text);
    if (!value || *value < least) return false;
    number = *value;
    return true;
}

bool setText(std::string_view text, std::string& field) {
    field = text;
    return !text.empty();
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

constexpr std::array kOptions{
    Option{"--scene", "NAME", "start with this scene",
           [](PlayerOptions& o, std::string_view v) { return setText(v, o.scene); }},
    Option{"--headless", "", "no window, no GL, no audio: as fast as it can",
           [](PlayerOptions& o, std::string_view) { return o.headless = true; }},
    Option{"--frames", "N", "stop after N ticks; of the benchmark: measure N frames",
           [](PlayerOptions& o, std::string_view v) { return setNumber(v, 0, o.frames); }},
    Option{"--hash", "", "print the hash of the whole simulation state last",
           [](PlayerOptions& o, std::string_view) { return o.hash = true; }},
    Option{"--hash-every", "N", "print it every N ticks",
           [](PlayerOptions& o, std::string_view v) { return setNumber(v, 1, o.hashEvery); }},
    Option{"--screenshot", "FILE.png", "save the last frame",
           [](PlayerOptions& o, std::string_view v) { return setText(v, o.screenshot); }},
    Option{"--capture", "DIR", "save every frame",
           [](PlayerOptions& o, std::string_view v) { return setText(v, o.capture); }},
    Option{"--record", "FILE", "record the input",
           [](PlayerOptions& o, std::string_view v) { return setText(v, o.record); }},
    Option{"--replay", "FILE", "play recorded input",
           [](PlayerOptions& o, std::string_view v) { return setText(v, o.replay); }},
    Option{"--effects", "", "list what the scene calls for, and what it costs",
           [](PlayerOptions& o, std::string_view) { return o.effects = true; }},
    Option{"--all-effects", "", "run every effect, called for or not, to compare",
           [](PlayerOptions& o, std::string_view) { return o.allEffects = true; }},
    Option{"--benchmark", "", "measure 10,000 moving, colliding, drawn entities",
           [](PlayerOptions& o, std::string_view) { return o.benchmark = true; }},
    Option{"--entities", "N", "so many in the benchmark, 1..1000000", &setEntities},
    Option{"--seed", "N", "seed of the game's random numbers", &setSeed},
    Option{"--scale", "N", "window size in multiples of the game's resolution, 1..16", &setScale},
    Option{"--window", "WxH", "window size in px, e.g. 1280x720", &setWindow},
    Option{"--fullscreen", "", "fill the screen",
           [](PlayerOptions& o, std::string_view) { return o.fullscreen = true; }},
    Option{"--physics-view", "LIST",
           "show the physics (F3; Ctrl+digit and Ctrl+Shift+digit choose): all, or of\n"
           "                          shapes,contacts,normals,impulses,friction,joints,jointForces,\n"
           "                          velocities,centres,islands,triggers,fields,sleep,sweeps,bounds,\n"
           "                          broadPhase,paths,times,counts",
           &setPhysicsView},
    Option{"--help", "", "this text", [](PlayerOptions& o, std::string_view) { return o.help = true; }},
};

const Option* findOption(std::string_view name) {
    for (const Option& option : kOptions) {
        if (option.name == name) return &option;
    }
    return nullptr;
}

Error unknownOption(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Option& option : kOptions) {
        names.push_back(option.name);
    }
    const std::string_view near = closestName(name, names);
    return {"command line", format("there is no option \"{}\"", name),
            near.empty() ? std::string{"--help lists them"} : format("did you mean {}?", near)};
}

}  // namespace

Result<PlayerOptions> parsePlayerOptions(std::span<const char* const> arguments) {
    PlayerOptions options;
    bool hasProject = false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        std::string_view name = arguments[i];
        if (!startsWith(name, "-")) {
            if (hasProject) {
                return Error{"command line", format("\"{}\" is a second project", name), "name one project"};
            }
            options.project = name;
            hasProject = true;
            continue;
        }
        std::string_view value;
        const std::size_t equals = name.find('=');
        if (equals != std::string_view::npos) {
            value = name.substr(equals + 1);
            name = name.substr(0, equals);
        }
        const Option* option = findOption(name);
        if (option == nullptr) return unknownOption(name);
        if (!option->value.empty() && equals == std::string_view::npos && i + 1 < arguments.size()) {
            value = arguments[++i];
        }
        if (!option->set(options, value)) {
            return Error{"command line", format("{} cannot be \"{}\"", name, value),
                         format("write {} {}: {}", option->name, option->value, option->doc)};
        }
    }
    return options;
}

std::string playerUsage() {
    std::string text = "usage: plumb-player [PROJECT] [options]\n\n";
    for (const Option& option : kOptions) {
        std::string line = format("  {} {}", option.name, option.value);
        line.resize(26, ' ');
        text += line + std::string{option.doc} + "\n";
    }
    return text;
}

}  // namespace plumb
