#pragma once

#include "tests/accuracy/reference/scene.hpp"

namespace plumb::reference {

/// A scalar of two poses, and how it grows with them.
struct Gradient {
    Triple a, b;
    double value = 0.0;
};

Gradient gradientOf(const Measure& measure, Triple poseA, Triple poseB);

/// Where two outlines touch or may come to: a corner of one before a side of the other, or two corners with
/// rounding between them. It is written in the frames of the bodies, so that it has a distance at any pose.
struct Touch {
    std::uint64_t key = 0;  ///< names the two outlines and what of them touches
    std::uint32_t outlineA = 0, outlineB = 0;
    std::uint32_t bodyA = 0, bodyB = 0;
    bool hasSide = false;  ///< else two corners
    bool sideOfA = false;  ///< the side belongs to A and the corner to B, or the other way round
    Point a, b;            ///< in the bodies' frames: the corner, or a point of the side
    Point normal;          ///< in the frame of the side's body, outward
    double radiusA = 0.0, radiusB = 0.0;
    double friction = 0.0, bounciness = 0.0, surfaceSpeed = 0.0;
};

/// A touch at two poses.
struct TouchView {
    Point point;       ///< m
    Point normal;      ///< from A to B
    double gap = 0.0;  ///< m; below 0 they overlap
};

TouchView viewOf(const Touch& touch, Triple poseA, Triple poseB);
/// Of the gap, along the normal.
Gradient normalGradient(const TouchView& view, Triple poseA, Triple poseB);
/// Of the way of B over A along perpendicular(normal); it has no value.
Gradient tangentGradient(const TouchView& view, Triple poseA, Triple poseB);

}  // namespace plumb::reference
