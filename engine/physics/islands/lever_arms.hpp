#pragma once

#include <cstdint>

#include "physics/world.hpp"

namespace plumb::physics {

struct Workspace;

// Joints with long lever arms: if an arm is many times longer than the radius of gyration of its body, an
// impulse at the anchor does little but rotate the body, while a contact of the same body hardly rotates it.
// Solved sequentially (Gauss-Seidel) the two converge slowly, and warm starting repeats the remaining error
// in the next substep, so it grows. Islands in which the SIMD solver solves such joints therefore get more
// iterations.

inline constexpr std::uint8_t kMaxLeverage = 4;  ///< 16 iterations: more hardly helps any random scene

/// log2 of the velocity iterations that a joint needs, by the ratio of its longest arm to the radius of
/// gyration: 0 below 8, 1 below 16, and so on up to 4.
std::uint8_t leverageOf(const World& world, std::uint32_t joint);

/// Computes the levels of all awake joints. To be called when joints or masses have changed.
void findLeverages(const World& world, Workspace& work);

/// True if in this step the SIMD solver solves a joint of level 1 or higher sequentially with other
/// constraints.
bool hasLeverage(const World& world, const Workspace& work);

/// Computes the highest level of each island, by root: Workspace::leverageOf. @pre islands are up to date
void judgeLeverages(World& world, Workspace& work);

}  // namespace plumb::physics
