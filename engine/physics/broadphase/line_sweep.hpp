#pragma once

#include <algorithm>
#include <cmath>

#include "physics/broadphase/overlap.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// A moving box, as a broad phase searches for what it may hit. Conservative: it may report boxes that it
/// misses.
struct LineSweep {
    Vec2 from;          ///< m
    Vec2 displacement;  ///< m: displacement
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

/// True if the sweep may hit a box that overlaps its bounds.
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
