#pragma once

#include "math/vec2.hpp"

namespace plumb {

/// The border between the game's pixels and the metres of physics. A power of two, so that going there and
/// back changes no bit. Only physics_bridge, physics_queries and tile_bodies use it.
inline constexpr float kPixelsPerMetre = 64.0f;
inline constexpr float kMetresPerPixel = 1.0f / kPixelsPerMetre;

constexpr Vec2 toMetres(Vec2 pixels) { return pixels * kMetresPerPixel; }
constexpr Vec2 toPixels(Vec2 metres) { return metres * kPixelsPerMetre; }

}  // namespace plumb
