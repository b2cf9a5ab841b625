#pragma once

#include "core/result.hpp"

struct SDL_Window;

namespace plumb {

/// An OpenGL context of one window, current on the thread that created it.
class GlContext {
public:
    GlContext() = default;
    ~GlContext();
    GlContext(GlContext&& other) noexcept;
    GlContext& operator=(GlContext&& other) noexcept;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Creates one with the profile of requestGlProfile().
    /// @error the driver has no OpenGL 3.3
    static Result<GlContext> create(SDL_Window* window);

    void setVsync(bool on);

private:
    void* context_ = nullptr;
};

}  // namespace plumb
