#pragma once

#include <vector>

#include "tests/accuracy/reference/gradient.hpp"

namespace plumb::reference {

/// Appends the potential contacts of two outlines with gaps up to `margin`, m.
/// @return the distance, m; below 0: depth of the overlap; `kEndless` if it exceeds the margin
double findTouches(const Scene& scene, std::uint32_t outlineA, Triple poseA, std::uint32_t outlineB,
                   Triple poseB, double margin, std::vector<Touch>& touches);

}  // namespace plumb::reference
