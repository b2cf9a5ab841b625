#include "app/engine.hpp"

#include <cstdio>
#include <cstdlib>
#include <span>

#include "app/game_content.hpp"
#include "app/game_loop.hpp"
#include "app/options/game_options.hpp"
#include "app/recording/replay_choice.hpp"
#include "app/screen.hpp"
#include "app/step_clock.hpp"
#include "core/crash.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "platform/paths.hpp"
#include "scene/game_random.hpp"
#include "scene/systems/camera_system.hpp"

namespace plumb {
namespace {

/// Parses the options of PLUMB_OPTIONS, then those of the command line, which override them.
/// @param words  argv, including the program's path
Result<PlayerOptions> readGameOptions(std::span<const std::string> words) {
    std::vector<std::string> ofVariable;
    const char* text = std::getenv("PLUMB_OPTIONS");
    for (const std::string_view word : split(text != nullptr ? text : "", ' ')) {
        if (!word.empty()) ofVariable.emplace_back(word);
    }
    std::vector<const char*> arguments;
    for (const std::string& word : ofVariable) arguments.push_back(word.c_str());
    for (const std::string& word : words.subspan(words.empty() ? 0 : 1)) arguments.push_back(word.c_str());
    const std::span<const char* const> all = arguments;
    Result<PlayerOptions> given = parseGameOptions(all.subspan(ofVariable.size()));
    if (!given) return given;
    Result<PlayerOptions> options = parseGameOptions(all);
    if (options) return options;
    Error error = options.error();
    error.where = "PLUMB_OPTIONS";  // the command line alone is valid
    return error;
}

/// Returns the name of the program, e.g. "hello-code" for "build/bin/hello-code".
Path programOf(std::span<const std::string> words) {
    return words.empty() ? Path{} : Path{words.front()}.stem();
}

}  // namespace

Engine::Engine() : game_{std::make_unique<Game>()} {}

Engine::Engine(std::string title, int width, int height, int count, const char* const* words)
    : settings_{std::move(title),
                width,
                height,
                false,
                {static_cast<float>(width), static_cast<float>(height)}},
      words_(words, words + count),
      game_{std::make_unique<Game>()} {}

Engine::~Engine() = default;

void Engine::fixedUpdate([[maybe_unused]] float dt) {
    constexpr auto kTick = static_cast<float>(StepClock::kStep);
    PLUMB_ASSERT(dt > kTick * 0.99f && dt < kTick * 1.01f,
                 "a tick is 1/60 s; call fixedUpdate more often instead");
    if (game_->world.systemNames().empty()) game_->content.addSystems(game_->world);
    tickGame(*game_, InputFrame{});
}

std::optional<int> Engine::open() {
    reportCrashes("to find the line of the code, run it in a debugger: ./plumb play PROJECT --debug");
    Result<PlayerOptions> options = readGameOptions(words_);
    if (!options) {
        std::fprintf(stderr, "%s: %s\n", settings_.title.c_str(), options.error().text().c_str());
        return 2;
    }
    if (options->help) {
        std::fputs(gameUsage(programOf(words_).string()).c_str(), stdout);
        return 0;
    }
    options = begun(std::move(*options), settings_.title);
    if (!options) {
        logError("Input", options.error());
        return 1;
    }
    options_ = std::move(*options);
    if (options_.headless) return std::nullopt;
    Result<std::unique_ptr<Screen>> screen =
        Screen::open(withOptions(withPlayerSettings(settings_, options_, settings_.title), options_));
    if (!screen) {
        logError("Engine", screen.error());
        return 1;
    }
    screen_ = std::move(*screen);
    return std::nullopt;
}

int Engine::loop() {
    game_->assets = AssetStore{codeGameFolder(programOf(words_)), engineAssets()};
    game_->world.resource<GameRandom>().random = Random::seeded(seedOf(options_));
    game_->world.resource<PictureSize>().size = settings_.picture;
    game_->content.useSystemOrder(game_->world);
    game_->input.logging = screen_ != nullptr;
    game_->onCreate();
    if (game_->world.systemNames().empty()) game_->content.addSystems(game_->world);
    game_->effects.setProgramPin("pads",
                                 Pin::On);  // game code may read gamepads, which no component requests
    const int code = GameLoop{*game_, screen_.get(), options_, settings_.title}.run();
    screen_.reset();  // before the assets that its textures refer to
    return code;
}

}  // namespace plumb
