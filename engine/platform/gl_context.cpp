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

Result<GlContext> GlContext::create(SDL_Window* window) {
    GlContext made;
    // For isContextLost(). Drivers without it fail, or ignore it.
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION, SDL_GL_CONTEXT_RESET_LOSE_CONTEXT);
    made.context_ = SDL_GL_CreateContext(window);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION, SDL_GL_CONTEXT_RESET_NO_NOTIFICATION);
    if (made.context_ == nullptr) made.context_ = SDL_GL_CreateContext(window);
    if (made.context_ == nullptr) {
        return Error{"OpenGL", SDL_GetError(), "update the graphics driver; Plumb needs OpenGL 3.3"};
    }
    return made;
}

void GlContext::setVsync(bool on) { SDL_GL_SetSwapInterval(on ? 1 : 0); }

}  // namespace plumb
