#pragma once

#include <optional>
#include <string_view>

#include "physics/world.hpp"

namespace plumb::accuracy {

/// Mean distance of the moving bodies from their positions in the reference solution, m; nothing if the
/// reference solver finds no solution.
/// @param scene name of the scene; the reference solution is cached by it, as all runs of a scene start alike
/// @param start the world before its first step; of its settings only gravity is used
/// @param end   the world after `seconds`
std::optional<double> referenceError(std::string_view scene, const physics::World& start,
                                     const physics::World& end, double seconds);

}  // namespace plumb::accuracy
