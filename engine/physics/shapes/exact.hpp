#pragma once

#include "math/vec2.hpp"

namespace plumb::physics {

/// Twice the signed area of a triangle: positive if c is on the side of a-b towards which normals rotate.
/// Computed in double precision: differences of floats and their products fit, so the sign is correct and
/// zero is exact.
inline double areaOf(Vec2 a, Vec2 b, Vec2 c) {
    const double abx = static_cast<double>(b.x) - static_cast<double>(a.x);
    const double aby = static_cast<double>(b.y) - static_cast<double>(a.y);
    const double acx = static_cast<double>(c.x) - static_cast<double>(a.x);
    const double acy = static_cast<double>(c.y) - static_cast<double>(a.y);
    return abx * acy - aby * acx;
}

/// m: distance of `point` from the line through a and b; from a if both are equal.
inline double heightOver(Vec2 a, Vec2 b, Vec2 point) {
    const double x = static_cast<double>(b.x) - static_cast<double>(a.x);
    const double y = static_cast<double>(b.y) - static_cast<double>(a.y);
    const double size = std::sqrt(x * x + y * y);
    return size > 0.0 ? std::fabs(areaOf(a, b, point)) / size : static_cast<double>(distance(a, point));
}

}  // namespace plumb::physics
