#pragma once

#include <cstddef>
#include <string>

namespace plumb {

/// Sources of a vertex and a fragment shader in GLSL 3.30; with another first line valid GLSL ES 3.00.
struct ShaderSources {
    std::string vertex;
    std::string fragment;
};

/// Returns the shaders for sprites with up to `slots` textures.
ShaderSources spriteShaders(std::size_t slots);
/// Returns the shaders for colored triangles without texture.
ShaderSources geometryShaders();
/// Returns the shaders that fill the viewport with a texture.
ShaderSources textureShaders();

}  // namespace plumb
