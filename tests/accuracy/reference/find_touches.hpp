#pragma once

#include <vector>

#include "tests/accuracy/reference/gradient.hpp"

namespace plumb::reference {

/// Adds where two outlines are no further apart than `margin` (m).
/// @return m: how far they are apart; below 0 how deep they overlap; `kEndless` when further than the margin
double findTouches(const Scene& scene, std::uint32_t outlineA, Triple poseA, std::uint32_t outlineB,
                   Triple poseB, double margin, std::vector<Touch>& touches);

}  // namespace plumb::reference
