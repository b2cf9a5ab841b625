#include "platform/display.hpp"

#include <SDL.h>

namespace plumb {

double refreshRate() {
    SDL_Window* window = SDL_GL_GetCurrentWindow();
    const int display = window != nullptr ? SDL_GetWindowDisplayIndex(window) : -1;
    SDL_DisplayMode mode{};
    if (display < 0 || SDL_GetCurrentDisplayMode(display, &mode) != 0) return 0.0;
    return static_cast<double>(mode.refresh_rate);
}

}  // namespace plumb
