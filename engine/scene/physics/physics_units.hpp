#pragma once

#include <algorithm>

#include "math/vec2.hpp"
#include "physics/model/body.hpp"

namespace plumb {

/// The border between the game's pixels and the metres of physics. Only the files of the bridge cross it.
/// With a power of two, going there and back changes no bit.
struct PixelScale {
    float pixels = 64.0f;         ///< in a metre
    float metres = 1.0f / 64.0f;  ///< in a pixel

    friend bool operator==(PixelScale, PixelScale) = default;
};

/// From a component's field; what is too much gets the most there is.
constexpr physics::Quality qualityOf(int wanted) {
    return static_cast<physics::Quality>(
        std::clamp(wanted, int{physics::kQualityOfWorld}, int{physics::kMaxQuality}));
}

/// Of a scale that makes no sense, the usual one.
constexpr PixelScale pixelScale(float pixelsPerMetre) {
    if (!(pixelsPerMetre >= 1e-3f && pixelsPerMetre <= 1e5f)) return {};
    return {pixelsPerMetre, 1.0f / pixelsPerMetre};
}

constexpr Vec2 toMetres(Vec2 pixels, PixelScale scale) { return pixels * scale.metres; }
constexpr Vec2 toPixels(Vec2 metres, PixelScale scale) { return metres * scale.pixels; }

}  // namespace plumb
