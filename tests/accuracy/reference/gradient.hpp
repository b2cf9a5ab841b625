#pragma once

#include "tests/accuracy/reference/scene.hpp"

namespace plumb::reference {

/// Value and gradient of a scalar function of two poses.
struct Gradient {
    Triple a, b;         ///< derivatives by the pose of body A and of body B
    double value = 0.0;  ///< value of the function
};

Gradient gradientOf(const Measure& measure, Triple poseA, Triple poseB);

/// A potential contact of two outlines: a corner of one in front of a side of the other, or two rounded
/// corners. Stored in the frames of the bodies, so that its distance can be computed at any pose.
struct Touch {
    std::uint64_t key = 0;                     ///< unique key of the two outlines and their features
    std::uint32_t outlineA = 0, outlineB = 0;  ///< indices in Scene::outlines
    std::uint32_t bodyA = 0, bodyB = 0;        ///< indices in Scene::bodies
    bool hasSide = false;                      ///< true: corner and side; false: two corners
    bool sideOfA = false;  ///< true: the side belongs to A and the corner to B; false: reversed
    Point a, b;            ///< the corner, or a point of the side, in the bodies' frames
    Point normal;          ///< outward normal in the frame of the side's body
    double radiusA = 0.0, radiusB = 0.0;                          ///< rounding radii of the outlines, m
    double friction = 0.0, bounciness = 0.0, surfaceSpeed = 0.0;  ///< of the pair; conveyor speed in m/s
};

/// A contact evaluated at two poses.
struct TouchView {
    Point point;       ///< contact point, m
    Point normal;      ///< unit normal from A to B
    double gap = 0.0;  ///< gap, m; below 0: overlap
};

TouchView viewOf(const Touch& touch, Triple poseA, Triple poseB);
/// Gradient of the gap.
Gradient normalGradient(const TouchView& view, Triple poseA, Triple poseB);
/// Gradient of the displacement of B relative to A along perpendicular(normal); its value is not set.
Gradient tangentGradient(const TouchView& view, Triple poseA, Triple poseB);

}  // namespace plumb::reference
