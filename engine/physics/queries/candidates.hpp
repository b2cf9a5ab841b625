#pragma once

#include "physics/model/bodies.hpp"
#include "physics/queries/query.hpp"

namespace plumb::physics {

// Common parts of all queries: selecting the shapes to test, and transforming between world and body space.

/// True for a position or a displacement that is within range.
[[nodiscard]] bool isUsable(WorldPosition place);

/// The shapes that pass the filter and whose bounds overlap the box from `low` to `high` (m), in ascending
/// order of their indices. Valid until the next query.
std::span<const std::uint32_t> candidatesIn(World& world, WorldPosition low, WorldPosition high,
                                            const QueryFilter& filter);
/// The same for a box with these half sizes that moves from `from` by a displacement.
std::span<const std::uint32_t> candidatesAlong(World& world, WorldPosition from, Vec2 displacement, Vec2 half,
                                               const QueryFilter& filter);

[[nodiscard]] inline const BodyPose& poseOf(const World& world, std::uint32_t shape) {
    return world.bodies.pose[world.shapes.info[shape].body];
}
/// A frame relative to that of a body's shapes.
[[nodiscard]] Frame seenFrom(const BodyPose& body, WorldPosition position, Rot rotation);

/// m: bounding box of the outline relative to its position.
[[nodiscard]] AABB boundsOf(const World& world, const QueryShape& shape);
[[nodiscard]] std::span<const Corner> cornersOf(const World& world, const QueryShape& shape);
/// False if a number is out of range for a shape.
[[nodiscard]] bool isUsable(const World& world, const QueryShape& shape);

}  // namespace plumb::physics
