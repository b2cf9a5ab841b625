#pragma once

#include <algorithm>
#include <cmath>

#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

/// A moving box as broad phases look for it: which boxes can it meet? Errs on the side of too many.
struct LineSweep {
    Vec2 from;    ///< m
    Vec2 way;     ///< m
    Vec2 half;    ///< m: of the moving box, and what rounding may have lost on the way
    AABB bounds;  ///< m: all of the way; kNowhere when there is none to speak of
};

constexpr float kSweepSlack = 1e-6f;  // ratio: eight times the last bit of a float

inline LineSweep lineSweep(Vec2 from, Vec2 way, Vec2 half) {
    if (!isFinite(from) || !isFinite(way) || !isFinite(half)) return {{}, {}, {}, kNowhere};
    const Vec2 to = from + way;
    const Vec2 lost =
        Vec2{std::fabs(from.x) + std::fabs(way.x), std::fabs(from.y) + std::fabs(way.y)} * kSweepSlack;
    const Vec2 reach = max(half, {}) + lost;
    return {from, way, reach, usable({min(from, to) - reach, max(from, to) + reach})};
}

/// Whether a box that overlaps the bounds of the sweep may be met.
/// Source: C. Ericson, "Real-Time Collision Detection", 2005, 5.3.3 (separating axis of a segment and a box)
inline bool mayMeet(const LineSweep& sweep, const AABB& box) {
    const Vec2 middle = middleOf(box);
    const Vec2 half = box.max * 0.5f - box.min * 0.5f + sweep.half;
    const Vec2 slack{std::fabs(middle.x) * kSweepSlack, std::fabs(middle.y) * kSweepSlack};
    const float off = std::fabs(cross(sweep.way, middle - sweep.from));
    const float reach =
        std::fabs(sweep.way.x) * (half.y + slack.y) + std::fabs(sweep.way.y) * (half.x + slack.x);
    return !(off > reach);  // too large for a float: it may
}

}  // namespace plumb::physics
