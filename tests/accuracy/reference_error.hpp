#pragma once

#include <optional>
#include <string_view>

#include "physics/world.hpp"

namespace plumb::accuracy {

/// m: mean distance of the moving bodies of a scene without an exact answer from
/// the result of the reference solver; nothing if that has no answer.
/// @param scene its name; results may be cached by it, because all runs start alike
/// @param start as built, before its first step; only its gravity counts, not its
/// other settings
/// @param end the same world after `seconds`
std::optional<double> referenceError(std::string_view scene, const physics::World& start,
                                     const physics::World& end, double seconds);

}  // namespace plumb::accuracy
