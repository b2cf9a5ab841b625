#pragma once

#include <cstdint>
#include <span>

#include "physics/broadphase/broad_phase.hpp"

namespace plumb::physics {

/// How boxes are spread out, roughly.
struct Spread {
    float extent = 0.0f;   ///< m: three quarters are no larger, or twice that of half of them if that is less
    float spacing = 0.0f;  ///< m: from one to the next, were they spread evenly
    float aspect = 1.0f;   ///< how much wider than high all are together
};

Spread spreadOf(const Proxies& proxies, std::span<const std::uint32_t> ids);

}  // namespace plumb::physics
