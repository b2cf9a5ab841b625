#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "physics/broadphase/broad_phase.hpp"

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

/// The merged filters of several proxies.
struct FilterUnion {
    std::uint32_t layers = 0;
    std::uint32_t masks = 0;

    constexpr void add(const Filter& filter) {
        // Proxies of a positive group collide whatever their layers.
        const std::uint32_t overruled = filter.group > 0 ? 0xffffffffu : 0u;
        layers |= filter.layers | overruled;
        masks |= filter.mask | overruled;
    }
    /// False if none of them can pass this filter.
    [[nodiscard]] constexpr bool mayCollide(const Filter& filter) const {
        FilterUnion other;
        other.add(filter);
        return (other.layers & masks) != 0 && (other.masks & layers) != 0;
    }
};

/// The centre of a box; does not overflow even if its size does.
constexpr Vec2 middleOf(const AABB& box) { return box.min * 0.5f + box.max * 0.5f; }

}  // namespace plumb::physics
