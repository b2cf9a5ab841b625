#pragma once

#include "math/vec2.hpp"

namespace plumb::box_physics {

/// Every tolerance of the step, with what happens when it is larger or smaller.
struct Settings {
    /// m/s2. Which way is down for one-way platforms and "grounded"; screen down where it is zero.
    Vec2 gravity{0.0f, 9.81f};

    /// m. Closer than this counts as touching. Larger: contacts live longer; smaller: they flicker.
    float touchDistance = 0.0005f;

    /// m. Two outlines must overlap by more than this across a contact before it counts, so that a box
    /// sliding over the seam of two floors does not trip. Larger: corners feel rounded.
    float seamDistance = 0.002f;

    /// m. Overlap that is left alone, so that resting contacts stay. Smaller: jitter.
    float slop = 0.0005f;

    /// m per step that an overlap is pushed apart at most. Larger: deep overlaps pop.
    float maxPush = 0.1f;

    /// m. How far a body may be inside a one-way platform and still stand on it.
    float oneWayDepth = 0.01f;

    /// m/s. Slower hits do not bounce. Smaller: bodies never come to rest; larger: no small bounces.
    float bounceSpeed = 0.25f;

    /// Cosine of the steepest ground: a contact whose normal is closer to "up" grounds the body. 50 degrees.
    float groundCosine = 0.643f;

    /// m/s. Faster is cut to this. Protects the arithmetic from its own range.
    float maxSpeed = 20000.0f;

    int velocityIterations = 8;  ///< sweeps over all contacts; more: stiffer stacks, linear cost
    int positionIterations = 3;  ///< sweeps that push overlaps apart
};

}  // namespace plumb::box_physics
