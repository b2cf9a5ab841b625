#pragma once

#include <cstddef>
#include <string>

namespace plumb {

/// The source of a pair of shaders. Written for GLSL 3.30; with another first line it is GLSL ES 3.00.
struct ShaderSources {
    std::string vertex;
    std::string fragment;
};

/// Sprites with up to `slots` textures.
ShaderSources spriteShaders(std::size_t slots);
/// Plain colored triangles.
ShaderSources geometryShaders();
/// A picture that fills the viewport.
ShaderSources pictureShaders();

}  // namespace plumb
