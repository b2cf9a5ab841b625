#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::scenes {

struct Point {
    double x = 0.0;
    double y = 0.0;
};

/// An outline transformed to world coordinates, in double precision.
struct PlacedOutline {
    std::array<Point, 8> points;
    std::uint8_t count = 0;
    bool oneSided = false;
    double radius = 0.0;
    Point low;   ///< lower corner of its bounding box
    Point high;  ///< upper corner of its bounding box

    [[nodiscard]] std::span<const Point> corners() const { return {points.data(), count}; }
};

/// Transforms an outline from its body's frame to world coordinates.
PlacedOutline place(const Outline& outline, const Pose& pose);

/// Returns the penetration depth of two outlines, m: the shortest displacement that separates them; 0 if they
/// do not overlap. Shares no code with any engine, because it is used to compare them.
double overlapOf(const PlacedOutline& a, const PlacedOutline& b);

}  // namespace plumb::scenes
