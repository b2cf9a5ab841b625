#pragma once

#include <vector>

#include "tests/accuracy/reference/gradient.hpp"

namespace plumb::reference {

/// Appends the potential contacts of two outlines whose gap is at most `margin`, m, to `touches`.
/// @return the distance of the outlines, m; below 0: minus the overlap; `kEndless` if above the margin
double findTouches(const Scene& scene, std::uint32_t outlineA, Triple poseA, std::uint32_t outlineB,
                   Triple poseB, double margin, std::vector<Touch>& touches);

}  // namespace plumb::reference
