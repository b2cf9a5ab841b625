#pragma once

#include <cstddef>
#include <string>

namespace plumb {

/// The source of a pair of shaders. Written for GLSL 3.30; with another first line they are GLSL ES 3.00.
struct ShaderSources {
    std::string vertex;
    std::string fragment;
};

/// Sprites that choose among `slots` textures.
ShaderSources spriteShaders(std::size_t slots);
/// Plain colored triangles.
ShaderSources geometryShaders();
/// One picture over the whole viewport.
ShaderSources pictureShaders();

}  // namespace plumb
