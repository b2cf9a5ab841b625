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

/// An outline where its body is, in double precision.
struct PlacedOutline {
    std::array<Point, 8> points;
    std::uint8_t count = 0;
    bool oneSided = false;
    double radius = 0.0;
    Point low;  ///< of its bounds
    Point high;

    [[nodiscard]] std::span<const Point> corners() const { return {points.data(), count}; }
};

PlacedOutline place(const Outline& outline, const Pose& pose);

/// Penetration depth of two outlines: the shortest displacement that separates them; 0 if they are apart.
/// Shares no code with any engine, because it is used to judge them.
/// @return m
double overlapOf(const PlacedOutline& a, const PlacedOutline& b);

}  // namespace plumb::scenes
