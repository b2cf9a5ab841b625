#pragma once

#include <cstdint>

#include "box_physics/body.hpp"

namespace plumb::box_physics {

enum class ContactPhase : std::uint8_t { Began, Stayed, Ended };

/// One pair that touches, or has just stopped to. `a` was made before `b`, or sits in a lower place.
struct ContactEvent {
    ContactPhase phase = ContactPhase::Began;
    bool isTrigger = false;
    BodyId a;
    BodyId b;
    std::uint64_t userA = 0;
    std::uint64_t userB = 0;
    Vec2 normal;           ///< from a towards b
    Vec2 point;            ///< m
    float impulse = 0.0f;  ///< N s that kept them apart
};

}  // namespace plumb::box_physics
