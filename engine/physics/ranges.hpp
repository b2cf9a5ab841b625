#pragma once

namespace plumb::physics {

// Limits of values that come from the caller: enough for every game, and no result overflows a float.

inline constexpr double kFarthest = 1.0e9;    ///< m: distance from the origin
inline constexpr float kLargest = 1.0e6f;     ///< m: size of a shape, distance of its corners from the body
inline constexpr float kSmallest = 1.0e-4f;   ///< m: smaller sizes are lost in rounding
inline constexpr float kFastest = 1.0e6f;     ///< m/s, rad/s, and the same per second
inline constexpr float kStrongest = 1.0e15f;  ///< N, N m, N s, kg
inline constexpr float kRoughest = 100.0f;    ///< Coulomb coefficient
inline constexpr int kMaxIterations = 64;     ///< of the velocities, per substep

}  // namespace plumb::physics
