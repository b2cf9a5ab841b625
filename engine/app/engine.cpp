#include "app/engine.hpp"

#include <cstdlib>

#include "app/game_loop.hpp"
#include "app/screen.hpp"
#include "app/step_clock.hpp"
#include "app/system_order.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "platform/paths.hpp"

namespace plumb {
namespace {

/// The options that a code game is started with: its main() passes none, so they come from the environment.
Result<PlayerOptions> optionsFromEnvironment() {
    const char* text = std::getenv("PLUMB_OPTIONS");
    std::vector<std::string> words;
    for (const std::string_view word : split(text != nullptr ? text : "", ' ')) {
        if (!word.empty()) words.emplace_back(word);
    }
    std::vector<const char*> arguments;
    for (const std::string& word : words) {
        arguments.push_back(word.c_str());
    }
    return parsePlayerOptions(arguments);
}

}  // namespace

Engine::Engine() : game_{std::make_unique<Game>()} {}

Engine::Engine(std::string title, int width, int height)
    : title_{std::move(title)}, width_{width}, height_{height}, game_{std::make_unique<Game>()} {}

Engine::~Engine() = default;

void Engine::fixedUpdate([[maybe_unused]] float dt) {
    constexpr auto kTick = static_cast<float>(StepClock::kStep);
    PLUMB_ASSERT(dt > kTick * 0.99f && dt < kTick * 1.01f,
                 "a tick is 1/60 s; call fixedUpdate more often instead");
    if (game_->world.systemNames().empty()) addAllSystems(game_->world);
    tickGame(*game_, InputFrame{});
}

int Engine::open() {
    Result<PlayerOptions> options = optionsFromEnvironment();
    if (!options) {
        logError("Engine", options.error());
        return 2;
    }
    options_ = *options;
    if (options_.headless) return 0;
    const Vec2 picture{static_cast<float>(width_), static_cast<float>(height_)};
    Result<std::unique_ptr<Screen>> screen =
        Screen::open({title_, width_, height_, options_.fullscreen, picture, WindowScale::Fit});
    if (!screen) {
        logError("Engine", screen.error());
        return 1;
    }
    screen_ = std::move(*screen);
    return 0;
}

int Engine::loop() {
    game_->assets = AssetStore{std::filesystem::current_path(), engineAssets()};
    useSystemOrder(game_->world);
    game_->onCreate();
    if (game_->world.systemNames().empty()) addAllSystems(game_->world);
    game_->effects.setProgram("pads", Pin::On);  // its own code may ask for them
    const int code = GameLoop{*game_, screen_.get(), options_, title_}.run();
    screen_.reset();  // before the assets that its textures came from
    return code;
}

}  // namespace plumb
