#include "platform/gl_context.hpp"

#include <utility>

#include <SDL.h>

namespace plumb {

GlContext::~GlContext() {
    if (context_ != nullptr) SDL_GL_DeleteContext(context_);
}

GlContext::GlContext(GlContext&& other) noexcept : context_{std::exchange(other.context_, nullptr)} {}

GlContext& GlContext::operator=(GlContext&& other) noexcept {
    std::swap(context_, other.context_);
    return *this;
}

void GlContext::request() {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    // Required for a core context on macOS.
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, SDL_GL_CONTEXT_FORWARD_COMPATIBLE_FLAG);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 0);
}

Result<GlContext> GlContext::create(SDL_Window* window) {
    GlContext made;
    made.context_ = SDL_GL_CreateContext(window);
    if (made.context_ == nullptr) {
        return Error{"OpenGL", SDL_GetError(), "update the graphics driver; Plumb needs OpenGL 3.3"};
    }
    return made;
}

void GlContext::setVsync(bool on) { SDL_GL_SetSwapInterval(on ? 1 : 0); }

}  // namespace plumb
