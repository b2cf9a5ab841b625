#pragma once

#include <cstdint>

namespace plumb::physics {

/// What became of the pairs of shapes that the broad phase let through: each of `pairs` was sent away by one
/// of the three tests, or it touches.
struct DetectionCounts {
    std::uint32_t pairs = 0;           ///< whose bounds overlapped
    std::uint32_t apartByBounds = 0;   ///< their bounds do not any more: pairs no longer
    std::uint32_t apartByCircles = 0;  ///< their bounding circles do not meet
    std::uint32_t apartByAxes = 0;     ///< the outlines themselves are apart
    std::uint32_t touching = 0;
    std::uint32_t recycled = 0;  ///< of those that touch: moved too little to be looked at again
    std::uint32_t swept = 0;     ///< besides: pairs of shapes that were tested along the path of a fast body

    DetectionCounts& operator+=(const DetectionCounts& more) {
        pairs += more.pairs;
        apartByBounds += more.apartByBounds;
        apartByCircles += more.apartByCircles;
        apartByAxes += more.apartByAxes;
        touching += more.touching;
        recycled += more.recycled;
        swept += more.swept;
        return *this;
    }
};

}  // namespace plumb::physics
