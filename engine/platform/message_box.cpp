#include "platform/message_box.hpp"

#include <string_view>

#include <SDL.h>

namespace plumb {

bool showMessage(const std::string& title, const std::string& text) {
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) return false;
    // SDL would show the message even if SDL_VIDEODRIVER asks for a driver that draws into memory.
    const char* name = SDL_GetCurrentVideoDriver();
    const std::string_view driver = name != nullptr ? name : "dummy";
    const bool shown =
        driver != "offscreen" && driver != "dummy" &&
        SDL_ShowSimpleMessageBox(SDL_MESSAGEBOX_ERROR, title.c_str(), text.c_str(), nullptr) == 0;
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return shown;
}

}  // namespace plumb
