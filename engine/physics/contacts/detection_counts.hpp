#pragma once

#include <cstdint>
#include <initializer_list>

namespace plumb::physics {

/// Counts of the pairs of shapes that the broad phase found, by result: touching, or rejected by a test.
struct DetectionCounts {
    std::uint32_t pairs = 0;           ///< pairs that the narrow phase tested
    std::uint32_t apartByBounds = 0;   ///< pairs whose bounds no longer overlap; they are removed
    std::uint32_t apartByCircles = 0;  ///< pairs whose bounding circles do not overlap
    std::uint32_t apartByAxes = 0;     ///< pairs whose outlines do not overlap
    std::uint32_t touching = 0;        ///< pairs that touch
    std::uint32_t recycled = 0;        ///< touching pairs that moved so little that their points were reused
    std::uint32_t swept = 0;           ///< further pairs, tested along the path of a fast body

    DetectionCounts& operator+=(const DetectionCounts& more) {
        using Counts = DetectionCounts;
        for (std::uint32_t Counts::*const count :
             {&Counts::pairs, &Counts::apartByBounds, &Counts::apartByCircles, &Counts::apartByAxes,
              &Counts::touching, &Counts::recycled, &Counts::swept})
            this->*count += more.*count;
        return *this;
    }
};

}  // namespace plumb::physics
