#pragma once

#include "math/portable.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// Motion under drag for h seconds, v' = -drag v + a, solved exactly: v becomes keep * v + drive * a.
struct Decay {
    float keep;   ///< ratio of the speed that is left
    float drive;  ///< s: speed gained by 1 m/s2; also the distance at 1 m/s
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

/// s2: distance from rest under an acceleration of 1 m/s2: h^2 / 2 without drag.
inline float distanceUnder(float drag, float h) {
    const float x = drag * h;
    if (x >= kSlowDrag) return (h - decayOf(drag, h).drive) / drag;
    return 0.5f * h * h *
           (1.0f - x * (1.0f / 3.0f - x * (1.0f / 12.0f - x * (1.0f / 60.0f - x * (1.0f / 360.0f)))));
}

}  // namespace plumb::physics
