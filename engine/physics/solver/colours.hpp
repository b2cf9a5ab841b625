#pragma once

#include <cstdint>

#include "physics/model/contact.hpp"

namespace plumb::physics {

struct World;
struct Workspace;

/// Constraints of one color share no body, so they can be solved in parallel and in any order. The first
/// colors are for pairs of dynamic bodies. The last ones are for constraints with a static or kinematic body;
/// they are solved last, so that support by the ground wins.
inline constexpr int kColours = 32;
inline constexpr int kFirstFixedColour = 24;
/// Constraints that found no color: solved sequentially, before all colors.
inline constexpr std::uint8_t kOverflow = 32;

/// Allocates a color that neither body uses. Pass kNone for a body that is not dynamic.
std::uint8_t takeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB);
void freeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB, std::uint8_t colour);

/// Resizes Workspace::colourMasks to the world, and recomputes the masks after the world was overwritten.
void refreshColours(World& world, Workspace& work);

}  // namespace plumb::physics
