#pragma once

namespace plumb::physics {

/// Soft constraint parameters: a damped spring as a velocity constraint, unconditionally stable.
/// Source: E. Catto, "Soft Constraints", GDC 2011; "Solver2D", 2024.
struct Softness {
    float biasRate = 0.0f;  ///< 1/s
    float massScale = 1.0f;
    float impulseScale = 0.0f;
};

/// Returns the parameters of a spring for a substep of h seconds.
inline Softness softness(float hertz, float dampingRatio, float h) {
    if (hertz == 0.0f) return {0.0f, 1.0f, 0.0f};
    constexpr float kTurn = 6.28318530717958647692f;
    const float omega = kTurn * hertz;
    const float a = 2.0f * dampingRatio + h * omega;
    const float b = h * omega * a;
    const float c = 1.0f / (1.0f + b);
    return {omega / a, b * c, c};
}

}  // namespace plumb::physics
