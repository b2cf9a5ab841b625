#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

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
    Engine(std::string title, int width, int height);
    ~Engine();

    /// Creates the game and runs it until it is closed. The variable PLUMB_OPTIONS may hold the player's
    /// options, e.g. "--headless --frames 600 --hash".
    /// @return the program's exit code
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
        if (const int failed = open()) return failed;
        game_ = make();
        return loop();
    }
    int open();
    int loop();

    std::string title_ = "Plumb";
    int width_ = 1280;
    int height_ = 720;
    PlayerOptions options_;
    std::unique_ptr<Screen> screen_;
    std::unique_ptr<Game> game_;
};

}  // namespace plumb
