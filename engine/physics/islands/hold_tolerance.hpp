#pragma once

#include "physics/workspace.hpp"

namespace plumb::physics {

/// Determines the quality of each awake body where there is a tolerance, equal within an island:
/// Workspace::bodyScratch, by body. Measures contacts and joints at the start of the step, i.e. as the last
/// step left them. @pre Settings::tolerance is above 0, islands are up to date
void holdTolerance(World& world, Workspace& work);

/// Quality that a body and its joints ask for; kQualityOfWorld if they do not.
[[nodiscard]] Quality wishOf(const World& world, std::uint32_t body);

}  // namespace plumb::physics
