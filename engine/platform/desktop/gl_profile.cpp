#include "platform/gl_profile.hpp"

#include <SDL.h>
#include <SDL_opengl.h>

namespace plumb {

void requestGlProfile() {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    // Required for a core context on macOS.
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, SDL_GL_CONTEXT_FORWARD_COMPATIBLE_FLAG);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 0);
}

bool isContextLost() {
    using Status = unsigned(APIENTRY*)();
    static const auto status = [] {
        const bool knows = SDL_GL_ExtensionSupported("GL_KHR_robustness") == SDL_TRUE;
        return knows ? reinterpret_cast<Status>(SDL_GL_GetProcAddress("glGetGraphicsResetStatus")) : nullptr;
    }();
    static bool isLost = false;  // the driver may tell it only once
    isLost = isLost || (status != nullptr && status() != 0);
    return isLost;
}
bool canContextReturn() { return false; }
unsigned contextsRestored() { return 0; }

const char* shaderVersion() { return "#version 330 core\n"; }

}  // namespace plumb
