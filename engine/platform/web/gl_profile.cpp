#include "platform/gl_profile.hpp"

#include <emscripten/html5.h>

#include <SDL.h>

namespace plumb {
namespace {

bool isLost = false;
unsigned restored = 0;

void watchContext() {
    constexpr const char* kCanvas = "#canvas";  // the one that SDL uses
    emscripten_set_webglcontextlost_callback(kCanvas, nullptr, false, [](int, const void*, void*) -> EM_BOOL {
        isLost = true;
        return EM_TRUE;  // a browser gives the context back only if the page says that it handles this
    });
    emscripten_set_webglcontextrestored_callback(kCanvas, nullptr, false,
                                                 [](int, const void*, void*) -> EM_BOOL {
                                                     isLost = false;
                                                     ++restored;
                                                     return EM_TRUE;
                                                 });
}

}  // namespace

void requestGlProfile() {
    watchContext();
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_ALPHA_SIZE,
                        8);  // smoothed pictures are resolved into it, which needs the same format
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 0);
}

bool isContextLost() { return isLost; }
bool canContextReturn() { return true; }
unsigned contextsRestored() { return restored; }

const char* shaderVersion() { return "#version 300 es\n"; }

}  // namespace plumb
