#pragma once

#include <cstdint>

#include "physics/world.hpp"

namespace plumb::physics {

inline constexpr float kLightest = 1.0e-12f;  ///< kg: no body that can be pushed has less

/// Works out mass, centre of mass, inertia and reach of a body from its shapes. A dynamic body whose shapes
/// weigh nothing has 1 kg and does not turn. The body stays where it is; its velocity is that of the new
/// centre.
void updateMass(World& world, std::uint32_t body);

}  // namespace plumb::physics
