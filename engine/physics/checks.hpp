#pragma once

#include <string>

#include "core/result.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// What the world's setters accept. Each gives the Error to answer with, or Done.

inline constexpr double kFarthest = 1.0e9;  ///< m from the origin
inline constexpr float kLargest = 1.0e6f;   ///< m, of a shape
inline constexpr float kSmallest = 1.0e-4f;
inline constexpr float kFastest = 1.0e6f;     ///< m/s, rad/s
inline constexpr float kStrongest = 1.0e15f;  ///< N, N m, N s, kg

Error wrong(const char* where, const std::string& what, const char* remedy);

/// A finite number in a range.
Result<Done> checkNumber(const char* where, double value, double low, double high);
Result<Done> checkVector(const char* where, Vec2 value, float most);
Result<Done> checkPlace(const char* where, Place value);
Result<Done> checkQuality(const char* where, int quality);
Result<Done> checkAlive(const char* where, const World& world, BodyId body);

/// The first Error of several checks, or Done.
template <class... Checks>
Result<Done> firstOf(Checks... checks) {
    Result<Done> result = Done{};
    static_cast<void>(((checks.ok() || (result = checks, false)) && ...));
    return result;
}

}  // namespace plumb::physics
