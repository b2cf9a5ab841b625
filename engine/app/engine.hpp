#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/game.hpp"
#include "app/player_options.hpp"
#include "app/screen_settings.hpp"

namespace plumb {

class Screen;

/// Runs a game: window, loop, drawing, sound. Without run() it only simulates a world and opens no window.
class Engine {
public:
    /// Creates a world without a window, for tests and tools.
    Engine();

    /// @param title          title of the window and the game
    /// @param width, height  px, size of the window and of the game image
    /// @param count, words   argc and argv of main(), for command line options; --help lists them
    Engine(std::string title, int width, int height, int count = 0, const char* const* words = nullptr);
    ~Engine();

    /// Creates the game and runs it until it is closed. The environment variable PLUMB_OPTIONS may contain
    /// options too, e.g. "--headless --frames 600 --hash"; options of the command line override them.
    /// @return the exit code for main(): 2 if an option is invalid
    template <class G, class... Arguments>
    int run(Arguments&&... arguments) {
        static_assert(std::is_base_of_v<Game, G>, "a game derives from plumb::Game");
        return runMade([&]() -> std::unique_ptr<Game> {
            return std::make_unique<G>(std::forward<Arguments>(arguments)...);
        });
    }

    /// Window and game image, for changes before run(): a smaller image that is scaled, its scaling,
    /// fullscreen.
    ScreenSettings& settings() { return settings_; }

    World& getWorld() { return game_->world; }
    AssetStore& getAssets() { return game_->assets; }
    Input& getInput() { return game_->input; }

    /// Runs one tick without input. @param dt  s, must be 1/60
    void fixedUpdate(float dt);

private:
    template <class Make>
    int runMade(Make make) {
        if (const std::optional<int> ended = open()) return *ended;
        game_ = make();
        return loop();
    }
    /// Reads the options and opens the window. @return the exit code if the program must end now
    std::optional<int> open();
    int loop();

    ScreenSettings settings_;
    std::vector<std::string> words_;  ///< argv, including the program's path
    PlayerOptions options_;
    std::unique_ptr<Screen> screen_;
    std::unique_ptr<Game> game_;
};

}  // namespace plumb
