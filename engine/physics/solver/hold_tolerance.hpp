#pragma once

#include "physics/workspace.hpp"

namespace plumb::physics {

/// The quality that all bodies of an island get where there is a tolerance, by its root:
/// Workspace::bodyScratch. Looks at what contacts and joints are at the start of the step, which is what the
/// last one left of them.
/// @pre Settings::tolerance is above 0, islands are up to date
void holdTolerance(World& world, Workspace& work);

/// What its body and its joints ask for; kQualityOfWorld where they do not.
[[nodiscard]] Quality wishOf(const World& world, std::uint32_t body);

}  // namespace plumb::physics
