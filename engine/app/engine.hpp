#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/game.hpp"
#include "app/player_options.hpp"

namespace plumb {

class Screen;

/// Runs a game: window, loop, drawing, sound. Without run() it is a world to simulate, which needs no window.
class Engine {
public:
    /// A world without a window, for tests and tools.
    Engine();

    /// @param title          of the window and of the game
    /// @param width, height  of the window and of the game's picture (px)
    /// @param count, words   what main() was given, for the options of the command line; --help lists them
    Engine(std::string title, int width, int height, int count = 0, const char* const* words = nullptr);
    ~Engine();

    /// Creates the game and runs it until it is closed. The variable PLUMB_OPTIONS may hold options too, e.g.
    /// "--headless --frames 600 --hash"; those of the command line come after them.
    /// @return the program's exit code, for main() to return: 2 where an option is wrong
    template <class G, class... Arguments>
    int run(Arguments&&... arguments) {
        static_assert(std::is_base_of_v<Game, G>, "a game derives from plumb::Game");
        return runMade([&]() -> std::unique_ptr<Game> {
            return std::make_unique<G>(std::forward<Arguments>(arguments)...);
        });
    }

    World& getWorld() { return game_->world; }
    AssetStore& getAssets() { return game_->assets; }
    Input& getInput() { return game_->input; }

    /// One tick without input. @param dt  s; a tick is always 1/60 s, so this must be it
    void fixedUpdate(float dt);

private:
    template <class Make>
    int runMade(Make make) {
        if (const std::optional<int> ended = open()) return *ended;
        game_ = make();
        return loop();
    }
    /// @return the exit code where there is nothing to play
    std::optional<int> open();
    int loop();

    std::string title_ = "Plumb";
    int width_ = 1280;
    int height_ = 720;
    std::vector<std::string> words_;  ///< of the command line, the program first
    PlayerOptions options_;
    std::unique_ptr<Screen> screen_;
    std::unique_ptr<Game> game_;
};

}  // namespace plumb
