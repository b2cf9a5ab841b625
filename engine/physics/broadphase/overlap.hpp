#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// A box that overlaps no box, not even itself or an infinite one.
inline constexpr AABB kNowhere{
    {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()},
    {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}};

/// Returns valid bounds: inverted boxes and NaN become kNowhere, infinity becomes the largest float.
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
    /// False if no proxy of the union can collide with a proxy that has this filter.
    [[nodiscard]] constexpr bool mayCollide(const Filter& filter) const {
        FilterUnion other;
        other.add(filter);
        return (other.layers & masks) != 0 && (other.masks & layers) != 0;
    }
};

/// The centre of a box; does not overflow even if its size does.
constexpr Vec2 middleOf(const AABB& box) { return box.min * 0.5f + box.max * 0.5f; }

/// A moving box, slightly enlarged, for a search for all boxes that it may hit.
struct LineSweep {
    Vec2 from;          ///< m
    Vec2 displacement;  ///< m
    Vec2 half;          ///< m: half size of the moving box, plus an allowance for rounding
    AABB bounds;        ///< m: bounds of the whole sweep; kNowhere if the input is not finite
};

inline LineSweep lineSweep(Vec2 from, Vec2 displacement, Vec2 half) {
    if (!isFinite(from) || !isFinite(displacement) || !isFinite(half)) return {{}, {}, {}, kNowhere};
    const Vec2 to = from + displacement;
    const Vec2 lost =
        Vec2{std::fabs(from.x) + std::fabs(displacement.x), std::fabs(from.y) + std::fabs(displacement.y)} *
        2.0f * kRounding;
    const Vec2 reach = max(half, {}) + lost;
    return {from, displacement, reach, usable({min(from, to) - reach, max(from, to) + reach})};
}

/// True if the sweep may hit a box. @pre the box overlaps the bounds of the sweep
/// Source: C. Ericson, "Real-Time Collision Detection", 2005, 5.3.3 (separating axis of a segment and a box)
inline bool mayCollide(const LineSweep& sweep, const AABB& box) {
    const Vec2 middle = middleOf(box);
    const Vec2 half = box.max * 0.5f - box.min * 0.5f + sweep.half;
    const Vec2 slack{std::fabs(middle.x) * 2.0f * kRounding, std::fabs(middle.y) * 2.0f * kRounding};
    const float off = std::fabs(cross(sweep.displacement, middle - sweep.from));
    const float reach = std::fabs(sweep.displacement.x) * (half.y + slack.y) +
                        std::fabs(sweep.displacement.y) * (half.x + slack.x);
    return !(off > reach);  // true also for a NaN after an overflow
}

}  // namespace plumb::physics
