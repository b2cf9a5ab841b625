#pragma once

#include <cstdint>

#include "physics/contact.hpp"

namespace plumb::physics {

struct World;
struct Workspace;

/// Constraints of one colour share no body, so they can be solved at once and in any order. The first colours
/// are for pairs of bodies that both can be pushed; the last, solved last, for those with a fixed body, so
/// that what stands on the ground wins.
inline constexpr int kColours = 32;
inline constexpr int kFirstFixedColour = 24;
/// Of constraints that found no colour: they are solved one after the other, before all colours.
inline constexpr std::uint8_t kOverflow = 32;

/// Takes a colour that neither body has. Pass kNone for a body that cannot be pushed.
std::uint8_t takeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB);
/// Gives it back.
void freeColour(Workspace& work, std::uint32_t bodyA, std::uint32_t bodyB, std::uint8_t colour);

/// Makes Workspace::colourMasks fit the world, and fills them anew after the world was written over.
void refreshColours(World& world, Workspace& work);

}  // namespace plumb::physics
