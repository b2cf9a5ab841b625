#pragma once

#include <cmath>

#include "math/portable.hpp"
#include "math/vec2.hpp"

namespace plumb {

/// Returns the equivalent angle in [-pi, pi].
inline float wrapAngle(float angle) {
    if (angle >= -kPi && angle <= kPi) return angle;
    return angle - kTau * std::floor((angle + kPi) / kTau);
}

/// Interpolates between two angles along the shorter arc.
inline float lerpAngle(float from, float to, float t) { return from + wrapAngle(to - from) * t; }

constexpr float degreesFromRadians(float angle) { return angle * (180.0f / kPi); }
constexpr float radiansFromDegrees(float angle) { return angle * (kPi / 180.0f); }

inline Vec2 rotated(Vec2 v, float angle) {  // angle in rad, from x towards y
    if (angle == 0.0f) return v;
    const SinCos rotation = sinCos(angle);
    return {rotation.cos * v.x - rotation.sin * v.y, rotation.sin * v.x + rotation.cos * v.y};
}

}  // namespace plumb
