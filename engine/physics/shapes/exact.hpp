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

}  // namespace plumb::physics
