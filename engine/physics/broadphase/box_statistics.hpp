#pragma once

#include <cstdint>
#include <span>

#include "physics/broadphase/broad_phase.hpp"

namespace plumb::physics {

/// Statistics of the sizes and positions of boxes, roughly.
struct BoxStatistics {
    float extent = 0.0f;   ///< m: third quartile of the sizes, but at most twice their median
    float spacing = 0.0f;  ///< m: distance between neighbours, if the boxes were spread evenly
    float aspect = 1.0f;   ///< ratio of the width to the height of the area that they are spread over
};

BoxStatistics statisticsOf(const Proxies& proxies, std::span<const std::uint32_t> ids);

}  // namespace plumb::physics
