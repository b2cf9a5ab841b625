#pragma once

#include <cstdint>

#include "physics/world.hpp"

namespace plumb::physics {

inline constexpr float kLightest = 1.0e-12f;  ///< kg: minimum mass of a dynamic body

/// Computes mass, centre of mass, inertia and extent of a body from its shapes. A dynamic body whose shapes
/// have no mass gets 1 kg and cannot rotate. The shapes stay where they are; the velocity becomes that of the
/// new centre of mass. Joints keep their anchors on the shapes.
void updateMass(World& world, std::uint32_t body);
/// Moves the center of mass (m, in the frame of the shapes).
void moveCentre(World& world, std::uint32_t body, Vec2 centre);
/// updateMass() for a body that may touch something: if its center of mass moves, its contacts begin anew.
void updateMassInContact(World& world, std::uint32_t body);

}  // namespace plumb::physics
