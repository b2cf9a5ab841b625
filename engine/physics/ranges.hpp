#pragma once

namespace plumb::physics {

// Limits of values from the caller, large enough for games and small enough that no result overflows a float.

inline constexpr double kFarthest = 1.0e9;       ///< m: maximum distance from the origin
inline constexpr float kLargest = 1.0e6f;        ///< m: maximum size of a shape, and its reach from the body
inline constexpr float kSmallest = 1.0e-4f;      ///< m: minimum size; smaller sizes are lost in rounding
inline constexpr float kFastest = 1.0e6f;        ///< m/s, rad/s, m/s2, rad/s2: maximum speed, acceleration
inline constexpr float kStrongest = 1.0e15f;     ///< N, N m, N s, kg: maximum force, torque, impulse, mass
inline constexpr float kRoughest = 100.0f;       ///< maximum Coulomb coefficient
inline constexpr float kShortestStep = 1.0e-6f;  ///< s: minimum: kStrongest / substep^2 fits a float
inline constexpr float kLongestStep = 1.0f;      ///< s: maximum step length: kFastest (m/s) / kFastest (m/s2)
inline constexpr int kMaxIterations = 64;        ///< maximum of Settings::iterations

}  // namespace plumb::physics
