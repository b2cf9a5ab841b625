#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "math/rect.hpp"

namespace plumb::physics {

/// Overlaps no box, not even itself or an infinite one.
inline constexpr AABB kNowhere{
    {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()},
    {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}};

/// Bounds as all broad phases use them: inverted boxes and NaN become kNowhere, infinity becomes the largest
/// float.
constexpr AABB usable(const AABB& box) {
    constexpr float kMost = std::numeric_limits<float>::max();
    if (!(box.min.x <= box.max.x && box.min.y <= box.max.y)) return kNowhere;
    return {{std::clamp(box.min.x, -kMost, kMost), std::clamp(box.min.y, -kMost, kMost)},
            {std::clamp(box.max.x, -kMost, kMost), std::clamp(box.max.y, -kMost, kMost)}};
}

/// Like intersects(), but boxes that only touch overlap too.
constexpr bool touch(const AABB& a, const AABB& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// The layers and mask that a proxy of the group needs in addition to its own where the filters of several
/// proxies are merged into one: proxies of a positive group collide whatever their layers.
constexpr std::uint32_t overruledBy(std::int32_t group) { return group > 0 ? 0xffffffffu : 0u; }

/// The centre of a box; does not overflow even if its size does.
constexpr Vec2 middleOf(const AABB& box) { return box.min * 0.5f + box.max * 0.5f; }

}  // namespace plumb::physics
