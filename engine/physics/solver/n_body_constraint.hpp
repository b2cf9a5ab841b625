#pragma once

#include <cstdint>

#include "physics/solver/joint_block.hpp"

namespace plumb::physics {

/// Jacobian of a multi-body constraint with respect to one body.
struct NBodyJacobian {
    std::uint32_t body = 0;
    float x = 0.0f;
    float y = 0.0f;
    float turn = 0.0f;
};

/// Constraint that keeps a sum over up to four bodies at 0: gears and pulleys. They are rare, so they are
/// solved one by one. Jacobians are those of the start of the step.
struct NBodyConstraint {
    NBodyJacobian ends[4];
    std::int32_t count = 0;     ///< of ends
    std::int32_t reported = 0;  ///< the end whose force jointForce() reports
    float error = 0.0f;         ///< at the start of the step
    std::int32_t slots[4] = {};
    float inverseInertia[4] = {};
    float mass = 0.0f;
    float impulse = 0.0f;
    std::uint32_t joint = 0;
    std::uint8_t group = 0;

    void add(const NBodyJacobian& end) { ends[count++] = end; }
};

}  // namespace plumb::physics
