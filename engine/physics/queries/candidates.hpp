#pragma once

#include "physics/model/bodies.hpp"
#include "physics/queries/query.hpp"

namespace plumb::physics {

// Functions shared by all queries: selection of the shapes to test, and conversion from world to body space.

/// True for a position or a displacement that is finite and within range.
[[nodiscard]] bool isUsable(WorldPosition place);

/// Returns the shapes that pass the filter and whose bounds overlap the box from `low` to `high` (m), in
/// ascending order. Valid until the next query.
std::span<const std::uint32_t> candidatesIn(World& world, WorldPosition low, WorldPosition high,
                                            const QueryFilter& filter);
/// Returns such shapes for a box with half size `half` that moves from `from` by a displacement.
std::span<const std::uint32_t> candidatesAlong(World& world, WorldPosition from, Vec2 displacement, Vec2 half,
                                               const QueryFilter& filter);

[[nodiscard]] inline const BodyPose& poseOf(const World& world, std::uint32_t shape) {
    return world.bodies.pose[world.shapes.info[shape].body];
}
/// Converts a position and rotation in the world to a frame relative to that of the body's shapes.
[[nodiscard]] Frame relativeFrame(const BodyPose& body, WorldPosition position, Rot rotation);

/// Returns the bounding box (m) of the outline relative to its position.
[[nodiscard]] AABB boundsOf(const World& world, const QueryShape& shape);
[[nodiscard]] std::span<const Corner> cornersOf(const World& world, const QueryShape& shape);
/// True if all numbers of the outline are within range.
[[nodiscard]] bool isUsable(const World& world, const QueryShape& shape);

}  // namespace plumb::physics
