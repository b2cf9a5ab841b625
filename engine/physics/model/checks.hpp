#pragma once

#include <string>

#include "core/result.hpp"
#include "physics/ranges.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// Range checks of the setters. Each returns the Error to report, or Done.

Error wrong(const char* where, const std::string& what, const char* remedy);

/// Checks that a number is within a range; NaN is not.
Result<Done> checkNumber(const char* where, double value, double low, double high);
Result<Done> checkVector(const char* where, Vec2 value, float maximum);
Result<Done> checkPlace(const char* where, WorldPosition value);
Result<Done> checkKind(const char* where, BodyKind kind);
Result<Done> checkQuality(const char* where, int quality);
Result<Done> checkAlive(const char* where, const World& world, BodyId body);
Result<Done> checkAlive(const char* where, const World& world, ShapeId shape);
Result<Done> checkAlive(const char* where, const World& world, JointId joint);

/// @error a callback of the step is running, which must not change the world
Result<Done> checkOutside(const char* where, const World& world);
/// For functions that return no Error.
template <class Thing>
[[nodiscard]] bool mayChange(const World& world, Id<Thing> id) {
    return !world.isAsking && alive(world, id);
}

/// The first Error of several checks, or Done.
template <class... Checks>
Result<Done> firstOf(Checks... checks) {
    Result<Done> result = Done{};
    static_cast<void>(((checks.ok() || (result = checks, false)) && ...));
    return result;
}

}  // namespace plumb::physics
