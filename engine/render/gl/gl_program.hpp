#pragma once

#include <cstdint>
#include <string>

#include "core/result.hpp"

namespace plumb {

/// Name of an OpenGL object, like GLuint; OpenGL headers are included only in .cpp files of this folder.
using GlName = std::uint32_t;

/// A linked shader program and its uniform locations.
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

/// Compiles and links a program. @error the driver's message
Result<GlProgram> buildProgram(const std::string& vertexSource, const std::string& fragmentSource);

}  // namespace plumb
