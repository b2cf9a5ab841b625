#pragma once

#include <optional>

#include "physics/queries/query.hpp"

namespace plumb::physics {

// A straight line from `from` to `from + way`. Numbers that are not finite, and places further than 1e9 m
// from the origin, meet nothing. A ray that begins inside of a shape meets it at once; a segment has no
// inside, and a segment of a chain is met on its solid side only.

/// The first shape on the way; of several at the same distance, the one with the lowest number.
std::optional<CastHit> castRay(World& world, Place from, Vec2 way, const QueryFilter& filter = {});
/// True when anything is on the way.
bool isRayBlocked(World& world, Place from, Vec2 way, const QueryFilter& filter = {});
/// Everything on the way, each shape once: nearest first, of equals the lowest number first.
/// @param hits  replaced
void castRayAll(World& world, Place from, Vec2 way, const QueryFilter& filter, std::vector<CastHit>& hits);

}  // namespace plumb::physics
