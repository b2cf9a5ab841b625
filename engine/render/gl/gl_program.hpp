#pragma once

#include <cstdint>
#include <string>

#include "core/result.hpp"

namespace plumb {

/// Name of an OpenGL object: GL headers stay inside the sources of this folder.
using GlName = std::uint32_t;

/// A linked pair of shaders and its uniform locations.
struct GlProgram {
    GlName name = 0;
    int viewX = -1;
    int viewY = -1;
    int viewOffset = -1;
    int tint = -1;
    int texelScale = -1;
    int up = -1;
    std::size_t slots = 0;
};

/// @error the driver's message about the source
Result<GlProgram> buildProgram(const std::string& vertexSource, const std::string& fragmentSource);

}  // namespace plumb
