#pragma once

#include "tests/accuracy/reference/scene.hpp"

namespace plumb::reference {

/// A scalar function of two poses, and its gradient.
struct Gradient {
    Triple a, b;
    double value = 0.0;
};

Gradient gradientOf(const Measure& measure, Triple poseA, Triple poseB);

/// A potential contact of two outlines: a corner of one in front of a side of the other, or two rounded
/// corners. Stored in the frames of the bodies, so that its distance can be computed at any pose.
struct Touch {
    std::uint64_t key = 0;  ///< identifies the two outlines and their features
    std::uint32_t outlineA = 0, outlineB = 0;
    std::uint32_t bodyA = 0, bodyB = 0;
    bool hasSide = false;  ///< else two corners
    bool sideOfA = false;  ///< the side belongs to A and the corner to B, or the other way round
    Point a, b;            ///< in the bodies' frames: the corner, or a point of the side
    Point normal;          ///< in the frame of the side's body, outward
    double radiusA = 0.0, radiusB = 0.0;
    double friction = 0.0, bounciness = 0.0, surfaceSpeed = 0.0;
};

/// A contact at two poses.
struct TouchView {
    Point point;       ///< m
    Point normal;      ///< from A to B
    double gap = 0.0;  ///< m; below 0 they overlap
};

TouchView viewOf(const Touch& touch, Triple poseA, Triple poseB);
/// Of the gap, along the normal.
Gradient normalGradient(const TouchView& view, Triple poseA, Triple poseB);
/// Of the displacement of B over A along perpendicular(normal); it has no value.
Gradient tangentGradient(const TouchView& view, Triple poseA, Triple poseB);

}  // namespace plumb::reference
