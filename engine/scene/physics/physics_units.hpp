#pragma once

#include <algorithm>

#include "math/vec2.hpp"
#include "physics/model/body.hpp"

namespace plumb {

/// Conversion between the game's pixels and the metres of the physics. Only engine/scene/physics uses it. If
/// `pixels` is a power of two, converting there and back is exact.
struct PixelScale {
    float pixels = 64.0f;         ///< px per metre
    float metres = 1.0f / 64.0f;  ///< m per pixel

    friend bool operator==(PixelScale, PixelScale) = default;
};

/// Converts the quality field of a component, clamped to the valid range.
constexpr physics::Quality qualityOf(int wanted) {
    return static_cast<physics::Quality>(
        std::clamp(wanted, int{physics::kQualityOfWorld}, int{physics::kMaxQuality}));
}

/// Returns the conversion for this scale, or the default of 64 px per metre if it is invalid.
constexpr PixelScale pixelScale(float pixelsPerMetre) {
    if (!(pixelsPerMetre >= 1e-3f && pixelsPerMetre <= 1e5f)) return {};
    return {pixelsPerMetre, 1.0f / pixelsPerMetre};
}

constexpr Vec2 toMetres(Vec2 pixels, PixelScale scale) { return pixels * scale.metres; }
constexpr Vec2 toPixels(Vec2 metres, PixelScale scale) { return metres * scale.pixels; }

}  // namespace plumb
