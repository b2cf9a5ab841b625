#pragma once

#include <optional>

#include "physics/queries/query.hpp"

namespace plumb::physics {

// An outline that is moved along a straight way without turning. What it overlaps at the start is met at
// once, at fraction 0; what it only touches there is not met by a way that leads off it or along it. A
// segment of a chain is met by what comes from its solid side only. Numbers that are not finite or absurd
// meet nothing.

/// The first shape on the way; of several at the same distance, the one with the lowest number.
std::optional<CastHit> castShape(World& world, const QueryShape& shape, Vec2 way,
                                 const QueryFilter& filter = {});
/// Everything on the way, each shape once: nearest first, of equals the lowest number first.
/// @param hits  replaced
void castShapeAll(World& world, const QueryShape& shape, Vec2 way, const QueryFilter& filter,
                  std::vector<CastHit>& hits);

}  // namespace plumb::physics
