#pragma once

#include <cstdint>

#include "physics/solver/joint_block.hpp"

namespace plumb::physics {

/// How one body takes part in a tie: how its value grows with the body's velocity.
struct TieEnd {
    std::uint32_t body = 0;
    float x = 0.0f;
    float y = 0.0f;
    float turn = 0.0f;
};

/// A sum over up to four bodies that is to stay 0: gears and pulleys. Few, so they are solved one by one. Its
/// directions are those of the start of the step.
struct Tie {
    TieEnd ends[4];
    std::int32_t count = 0;     ///< of ends
    std::int32_t reported = 0;  ///< the end that jointForce() tells of
    float error = 0.0f;         ///< at the start of the step
    std::int32_t slots[4] = {};
    float inverseInertia[4] = {};
    float mass = 0.0f;
    float impulse = 0.0f;
    std::uint32_t joint = 0;
    std::uint8_t group = 0;

    void add(const TieEnd& end) { ends[count++] = end; }
};

}  // namespace plumb::physics
