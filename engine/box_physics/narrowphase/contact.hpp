#pragma once

#include <cstdint>

#include "math/vec2.hpp"

namespace plumb::box_physics {

/// One place where two bodies touch, or will within this step.
struct Contact {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    Vec2 normal;              ///< from b towards a
    Vec2 point;               ///< m
    float separation = 0.0f;  ///< m at the start of the step; negative when they overlap
    float time = 0.0f;        ///< s into the step when they meet
    float friction = 0.0f;
    float targetSpeed = 0.0f;     ///< m/s apart after the step, from bouncing
    float mass = 0.0f;            ///< kg that the pair puts against an impulse along the normal
    float normalImpulse = 0.0f;   ///< N s
    float tangentImpulse = 0.0f;  ///< N s
    bool isTrigger = false;
    bool skipped = false;  ///< lies behind something that is hit earlier
};

}  // namespace plumb::box_physics
