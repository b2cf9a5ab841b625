#pragma once

#include <cstdint>

#include "physics/world.hpp"

namespace plumb::physics {

struct Workspace;

// Joints whose arms are many times longer than their body is wide: a push at such an anchor does next to
// nothing but turn the body, while a contact of the same body hardly turns it. Solved by turns the two take
// long to agree, and what they have not agreed on is given again in the next substep: it grows. So islands
// in which lanes solve such joints are iterated more often.

inline constexpr std::uint8_t kMostLeverage = 4;  ///< 16 iterations: more helps hardly any random scene

/// log2 of the velocity iterations that a joint needs, by the longest arm in radii of gyration: 0 up to 8,
/// 1 up to 16, and so on to 4.
std::uint8_t leverageOf(const World& world, std::uint32_t joint);

/// Notes the leverage of all awake joints. When joints or masses have changed.
void findLeverages(const World& world, Workspace& work);

/// True when lanes solve a joint of some leverage in this step, by turns with something else.
bool hasLeverage(const World& world, const Workspace& work);

/// The highest leverage of each island: by root in Workspace::leverageOf.
/// @pre islands are up to date
void judgeLeverages(World& world, Workspace& work);

}  // namespace plumb::physics
