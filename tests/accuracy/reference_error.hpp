#pragma once

#include <optional>
#include <string_view>

#include "physics/world.hpp"

namespace plumb::accuracy {

/// m: how far the bodies of a scene without an exact answer are from where the reference solver has them, as
/// the mean over those that move; none where there is no such answer.
/// @param scene    its name; what was worked out once may be kept by it, as all start alike
/// @param start    as it was built, before its first step; its settings say how `end` was made and do not
///                 count here, but for gravity
/// @param end      the same world after `seconds`
std::optional<double> referenceError(std::string_view scene, const physics::World& start,
                                     const physics::World& end, double seconds);

}  // namespace plumb::accuracy
