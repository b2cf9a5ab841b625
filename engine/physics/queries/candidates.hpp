#pragma once

#include "physics/queries/query.hpp"

namespace plumb::physics {

// What all queries share: who comes into question.

[[nodiscard]] bool isUsable(Place place);
[[nodiscard]] bool isUsable(Vec2 way);

/// Shapes whose bounds are near the box from `low` to `high` (m) and that the filter lets pass; in the order
/// of their numbers. Valid until the next query.
std::span<const std::uint32_t> candidatesIn(World& world, Place low, Place high, const QueryFilter& filter);
/// The same for a box with these half sizes that moves from `from` along `way`.
std::span<const std::uint32_t> candidatesAlong(World& world, Place from, Vec2 way, Vec2 half,
                                               const QueryFilter& filter);

[[nodiscard]] inline const BodyPose& poseOf(const World& world, std::uint32_t shape) {
    return world.bodies.pose[world.shapes.info[shape].body];
}
/// Nearest first, of equals the lowest number first.
void sortByFraction(std::vector<CastHit>& hits);

/// A place as the shapes of a body see it: differences are taken first, so it is as exact far from the
/// origin.
[[nodiscard]] Vec2 seenFrom(const BodyPose& body, Place place);
/// A frame as the shapes of a body see it.
[[nodiscard]] Frame seenFrom(const BodyPose& body, Place position, Rot rotation);
/// The way back.
[[nodiscard]] Place placeOf(const BodyPose& body, Vec2 point);

[[nodiscard]] ShapeId idOf(const World& world, std::uint32_t shape);

/// m: the box around an outline, from its position.
[[nodiscard]] AABB boundsOf(const World& world, const QueryShape& shape);
[[nodiscard]] std::span<const Corner> cornersOf(const World& world, const QueryShape& shape);
/// False for a shape with numbers that no shape may have.
[[nodiscard]] bool isUsable(const World& world, const QueryShape& shape);

}  // namespace plumb::physics
