#include "platform/page.hpp"

#include <emscripten.h>
#include <utility>

#include <SDL.h>

#include "platform/key_codes.hpp"

namespace plumb {
namespace {

std::function<std::string(bool afterFailure)> linkMaker;

}  // namespace

bool hasPage() { return true; }
void offerLink(std::function<std::string(bool afterFailure)> makeLink) { linkMaker = std::move(makeLink); }

void tellPage(std::string_view topic, std::string_view text) {
    // Played without a browser, Module has no such function.
    // clang-format off
    EM_ASM({ if (Module['onGame']) Module['onGame'](UTF8ToString($0, $1), UTF8ToString($2, $3)); },
           topic.data(), topic.size(), text.data(), text.size());
    // clang-format on
}

}  // namespace plumb

// What the page calls.

/// Returns the link of the run so far; empty if there is none. It is valid until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* plumbLink(int afterFailure) {
    static std::string link;
    link = plumb::linkMaker ? plumb::linkMaker(afterFailure != 0) : std::string{};
    return link.c_str();
}

/// Presses or releases a key, as a keyboard does. @param usage  its USB usage code
extern "C" EMSCRIPTEN_KEEPALIVE void plumbKey(int usage, int down) {
    SDL_Event event{};
    event.type = down != 0 ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.state = down != 0 ? SDL_PRESSED : SDL_RELEASED;
    event.key.keysym.scancode = static_cast<SDL_Scancode>(usage);
    SDL_PushEvent(&event);
}
