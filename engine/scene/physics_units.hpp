#pragma once

#include "math/vec2.hpp"

namespace plumb {

/// The border between the game's pixels and the metres of physics. Only the files of the bridge cross it.
/// With a power of two, going there and back changes no bit.
struct PixelScale {
    float pixels = 64.0f;         ///< in a metre
    float metres = 1.0f / 64.0f;  ///< in a pixel

    friend bool operator==(PixelScale, PixelScale) = default;
};

constexpr PixelScale pixelScale(float pixelsPerMetre) { return {pixelsPerMetre, 1.0f / pixelsPerMetre}; }

constexpr Vec2 toMetres(Vec2 pixels, PixelScale scale) { return pixels * scale.metres; }
constexpr Vec2 toPixels(Vec2 metres, PixelScale scale) { return metres * scale.pixels; }

}  // namespace plumb
