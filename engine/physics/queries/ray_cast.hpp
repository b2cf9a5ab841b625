#pragma once

#include "physics/queries/query.hpp"

namespace plumb::physics {

// Ray casts along the line from `from` to `from + displacement`. Values that are not finite and
// positions further than 1e9 m from the origin hit nothing. A ray that starts inside a shape hits
// it at fraction 0. A segment has no inside, and a chain segment is only hit on its solid side.

/// Finds the first shape hit; at equal distances the one with the lowest index.
std::optional<CastHit> castRay(World& world, WorldPosition from, Vec2 displacement,
                               const QueryFilter& filter = {});
bool isRayBlocked(World& world, WorldPosition from, Vec2 displacement, const QueryFilter& filter = {});
/// Finds all shapes hit, each once: nearest first; at equal distances the lowest index first.
void castRayAll(World& world, WorldPosition from, Vec2 displacement, const QueryFilter& filter,
                std::vector<CastHit>& hits);

}  // namespace plumb::physics
