#include "physics/queries/overlap.hpp"

#include "physics/model/shapes.hpp"
#include "physics/narrowphase/distance.hpp"
#include "physics/queries/candidates.hpp"
#include "physics/ranges.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

void overlapShape(World& world, const QueryShape& shape, const QueryFilter& filter,
                  std::vector<ShapeId>& found) {
    found.clear();
    if (!isUsable(world, shape)) return;
    const Convex outline = convexOf(shape.geometry, cornersOf(world, shape));
    const AABB box = boundsOf(world, shape);
    for (const std::uint32_t other :
         candidatesIn(world, shape.position + box.min, shape.position + box.max, filter)) {
        const Convex theirs = convexOf(world.shapes.geometry[other], world.shapes.corners);
        const Frame frame = seenFrom(poseOf(world, other), shape.position, shape.rotation);
        if (distanceBetween(theirs, outline, frame).distance <= 0.0f) found.push_back(idOf(world, other));
    }
}

void overlapBox(World& world, WorldPosition low, WorldPosition high, const QueryFilter& filter,
                std::vector<ShapeId>& found) {
    const Vec2 half = 0.5f * (high - low);
    overlapShape(world, {.geometry = box(half), .position = low + half, .rotation = {}}, filter, found);
}

void overlapCircle(World& world, WorldPosition centre, float radius, const QueryFilter& filter,
                   std::vector<ShapeId>& found) {
    overlapShape(world, {.geometry = circle(radius), .position = centre, .rotation = {}}, filter, found);
}

void overlapPoint(World& world, WorldPosition point, const QueryFilter& filter, std::vector<ShapeId>& found) {
    found.clear();
    if (!isUsable(point)) return;
    for (const std::uint32_t shape : candidatesIn(world, point, point, filter)) {
        const Vec2 seen = localPoint(poseOf(world, shape), point);
        if (containsPoint(world.shapes.geometry[shape], world.shapes.corners, seen))
            found.push_back(idOf(world, shape));
    }
}

std::optional<ClosestHit> closestPoint(World& world, WorldPosition place, float within,
                                       const QueryFilter& filter) {
    if (!isUsable(place) || !(within >= 0.0f) || !(within <= static_cast<float>(kFarthest)))
        return std::nullopt;
    const Vec2 reach{within, within};
    std::optional<ClosestHit> best;
    for (const std::uint32_t shape : candidatesIn(world, place + -reach, place + reach, filter)) {
        const BodyPose& pose = poseOf(world, shape);
        const ClosestPoint near =
            closestPoint(world.shapes.geometry[shape], world.shapes.corners, localPoint(pose, place));
        if (near.distance > within || (best && near.distance >= best->distance)) continue;
        best = ClosestHit{idOf(world, shape), bodyOf(world, idOf(world, shape)), worldPoint(pose, near.point),
                          rotate(pose.rotation, near.normal), near.distance};
    }
    return best;
}

}  // namespace plumb::physics
