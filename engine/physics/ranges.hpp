#pragma once

namespace plumb::physics {

// What numbers from outside may be: large enough for every game, small enough that nothing made of them is
// too large for a float.

inline constexpr double kFarthest = 1.0e9;    ///< m from the origin
inline constexpr float kLargest = 1.0e6f;     ///< m, of a shape, and of its corners from their body
inline constexpr float kSmallest = 1.0e-4f;   ///< m: smaller ones drown in rounding
inline constexpr float kFastest = 1.0e6f;     ///< m/s, rad/s, and what changes by so much in a second
inline constexpr float kStrongest = 1.0e15f;  ///< N, N m, N s, kg
inline constexpr float kRoughest = 100.0f;    ///< Coulomb coefficient

}  // namespace plumb::physics
