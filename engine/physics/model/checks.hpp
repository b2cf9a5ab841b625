#pragma once

#include <string>

#include "physics/ranges.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// Range checks of the setters. Each returns the Error to report, or Done. `where`: Error::where.

/// Makes the error that a function of the library returns for a wrong argument or a call at a wrong time.
inline Error usageError(const char* where, const std::string& what, const char* remedy) {
    return {where, what, remedy};
}

/// Returns the first Error of several checks, or Done.
template <class... Checks>
Result<Done> firstOf(Checks... checks) {
    Result<Done> result = Done{};
    static_cast<void>(((checks.ok() || (result = checks, false)) && ...));
    return result;
}

/// Checks that a number is within a range and not NaN.
Result<Done> checkNumber(const char* where, double value, double low, double high);
inline Result<Done> checkVector(const char* where, Vec2 value, double maximum) {
    return firstOf(checkNumber(where, value.x, -maximum, maximum),
                   checkNumber(where, value.y, -maximum, maximum));
}
inline Result<Done> checkPosition(const char* where, WorldPosition value) {
    return firstOf(checkNumber(where, value.x, -kFarthest, kFarthest),
                   checkNumber(where, value.y, -kFarthest, kFarthest));
}
Result<Done> checkKind(const char* where, BodyKind kind);
inline Result<Done> checkQuality(const char* where, int quality) {
    return checkNumber(where, quality, kQualityOfWorld, kMaxQuality);
}

/// @error called from a callback of StepOptions::hooks, which must not change the world
Result<Done> checkOutside(const char* where, const World& world);

constexpr const char* nameOf(BodyId) { return "body"; }
constexpr const char* nameOf(ShapeId) { return "shape"; }
constexpr const char* nameOf(JointId) { return "joint"; }
constexpr const char* nameOf(FieldId) { return "field"; }
constexpr const char* nameOf(SoftBodyId) { return "soft body"; }
Error staleIdError(const char* where, const std::string& what);
/// Checks that an object exists and may be changed now.
template <class Thing>
Result<Done> checkAlive(const char* where, const World& world, Id<Thing> id) {
    return alive(world, id) ? checkOutside(where, world) : staleIdError(where, nameOf(id));
}
/// True if an object exists and may be changed now: checkAlive() for functions that return no Error.
template <class Thing>
[[nodiscard]] bool mayChange(const World& world, Id<Thing> id) {
    return !world.work.isInCallback && alive(world, id);
}

}  // namespace plumb::physics
