#pragma once

#include "physics/model/bodies.hpp"
#include "physics/queries/query.hpp"
#include "physics/ranges.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

// Functions shared by all queries: selection of the shapes to test, and conversion from world to body space.

/// True for a position or a displacement that is finite and within range.
[[nodiscard]] inline bool isUsable(WorldPosition place) {
    return std::fabs(place.x) <= kFarthest && std::fabs(place.y) <= kFarthest;
}

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
[[nodiscard]] inline Frame relativeFrame(const BodyPose& body, WorldPosition position, Rot rotation) {
    return {localPoint(body, position), between(body.rotation, rotation)};
}

[[nodiscard]] inline std::span<const Corner> cornersOf(const World& world, const QueryShape& shape) {
    return shape.corners.empty() ? std::span<const Corner>{world.shapes.corners} : shape.corners;
}
/// Returns the bounding box (m) of the outline relative to its position.
[[nodiscard]] inline AABB boundsOf(const World& world, const QueryShape& shape) {
    return boundsOf(shape.geometry, cornersOf(world, shape), {{}, shape.rotation});
}
/// True if all numbers of the outline are within range.
[[nodiscard]] bool isUsable(const World& world, const QueryShape& shape);

}  // namespace plumb::physics
