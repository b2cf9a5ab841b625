#pragma once

#include "math/portable.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// Exact solution of motion under drag, v' = -drag v + a, after h seconds: v becomes keep * v + drive * a.
struct Decay {
    float keep;   ///< ratio of the remaining speed
    float drive;  ///< s: speed gained under 1 m/s2; also the distance covered from 1 m/s
};

inline Decay decayOf(float drag, float h) {
    const float x = drag * h;
    if (x < kSlowDrag) {
        const float series =
            1.0f - x * (1.0f / 2.0f - x * (1.0f / 6.0f - x * (1.0f / 24.0f - x * (1.0f / 120.0f))));
        return {1.0f - x * series, h * series};
    }
    const float keep = exponential(-x);
    return {keep, (1.0f - keep) / drag};
}

/// Returns the distance covered in h seconds from rest under 1 m/s2 (so in s2): h^2 / 2 without drag.
inline float distanceUnder(float drag, float h) {
    const float x = drag * h;
    if (x >= kSlowDrag) return (h - decayOf(drag, h).drive) / drag;
    return 0.5f * h * h *
           (1.0f - x * (1.0f / 3.0f - x * (1.0f / 12.0f - x * (1.0f / 60.0f - x * (1.0f / 360.0f)))));
}

}  // namespace plumb::physics
