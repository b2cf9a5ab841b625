#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "math/rect.hpp"

namespace plumb::physics {

/// Overlaps nothing, not even itself or everything.
inline constexpr AABB kNowhere{
    {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()},
    {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}};

/// Bounds as all broad phases take them: what is inverted or no number is nowhere, what is infinite ends at
/// the largest float.
constexpr AABB usable(const AABB& box) {
    constexpr float kMost = std::numeric_limits<float>::max();
    if (!(box.min.x <= box.max.x && box.min.y <= box.max.y)) return kNowhere;
    return {{std::clamp(box.min.x, -kMost, kMost), std::clamp(box.min.y, -kMost, kMost)},
            {std::clamp(box.max.x, -kMost, kMost), std::clamp(box.max.y, -kMost, kMost)}};
}

/// Like intersects(), but boxes that only touch count.
constexpr bool touch(const AABB& a, const AABB& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// Layers and mask that members of the group have on top of their own where several proxies are looked at as
/// one: they may meet each other whatever their layers.
constexpr std::uint32_t overruledBy(std::int32_t group) { return group > 0 ? 0xffffffffu : 0u; }

/// Where a box stands, also where its size is more than a float holds.
constexpr Vec2 middleOf(const AABB& box) { return box.min * 0.5f + box.max * 0.5f; }

}  // namespace plumb::physics
