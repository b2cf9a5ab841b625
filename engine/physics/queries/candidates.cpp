#include "physics/queries/candidates.hpp"

#include "physics/bounds.hpp"
#include "physics/model/shapes.hpp"
#include "physics/narrowphase/distance.hpp"
#include "physics/queries/overlap.hpp"
#include "physics/tuning.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

/// Returns the maximum rounding error (m) of float positions and bounds at this position.
float roundingAt(Vec2 place) { return largestOf(place) * kRounding; }

bool passes(const World& world, std::uint32_t shape, const QueryFilter& filter) {
    const Shapes& shapes = world.shapes;
    const std::uint32_t body = shapes.info[shape].body;
    if ((filter.layers & shapes.filter[shape].mask) == 0) return false;
    if (!filter.triggers && (shapes.info[shape].flags & kTrigger) != 0) return false;
    if (!(world.bodies.info[body].kind == BodyKind::Static ? filter.fixed : filter.movers)) return false;
    return !filter.except || filter.except.index != body ||
           filter.except.generation != world.bodies.info[body].generation;
}

std::span<const std::uint32_t> choose(World& world, const QueryFilter& filter) {
    std::vector<std::uint32_t>& found = world.work.get().candidates;
    std::erase_if(found, [&](std::uint32_t shape) { return !passes(world, shape, filter); });
    std::sort(found.begin(), found.end());
    return found;
}

bool overlaps(const AABB& bounds, WorldPosition low, WorldPosition high) {
    return low.x <= double{bounds.max.x} && double{bounds.min.x} <= high.x && low.y <= double{bounds.max.y} &&
           double{bounds.min.y} <= high.y;
}

/// Finds the shapes whose bounds overlap a box that is larger than a shape may be.
void overlapBounds(World& world, WorldPosition low, WorldPosition high, const QueryFilter& filter,
                   std::vector<ShapeId>& found) {
    found.clear();
    if (!isUsable(low) || !isUsable(high) || low.x > high.x || low.y > high.y) return;
    for (const std::uint32_t shape : candidatesIn(world, low, high, filter)) {
        if (overlaps(world.shapes.bounds[shape], low, high)) found.push_back(idOfShape(world, shape));
    }
}

}  // namespace

std::span<const std::uint32_t> candidatesIn(World& world, WorldPosition low, WorldPosition high,
                                            const QueryFilter& filter) {
    Workspace& work = world.work.get();
    updateBroadPhase(world, work);
    work.candidates.clear();
    const AABB box{toVec2(low), toVec2(high)};
    const float margin = std::max(roundingAt(box.min), roundingAt(box.max));
    work.broadPhase->query(grown(box, margin), filter.mask, work.candidates);
    return choose(world, filter);
}

std::span<const std::uint32_t> candidatesAlong(World& world, WorldPosition from, Vec2 displacement, Vec2 half,
                                               const QueryFilter& filter) {
    Workspace& work = world.work.get();
    updateBroadPhase(world, work);
    work.candidates.clear();
    const Vec2 start = toVec2(from);
    const float margin = std::max(roundingAt(start), roundingAt(start + displacement));
    work.broadPhase->cast(start, displacement, half + Vec2{margin, margin}, filter.mask, work.candidates,
                          Among::All);
    return choose(world, filter);
}

bool isUsable(const World& world, const QueryShape& shape) {
    const float squaredLength = lengthSquared({shape.rotation.cos, shape.rotation.sin});
    return isUsable(shape.position) && squaredLength > 0.999f && squaredLength < 1.001f &&
           checkGeometry(shape.geometry, cornersOf(world, shape)).ok();
}

void overlapShape(World& world, const QueryShape& shape, const QueryFilter& filter,
                  std::vector<ShapeId>& found) {
    found.clear();
    if (!isUsable(world, shape)) return;
    const Convex own = convexOf(shape.geometry, cornersOf(world, shape));
    const AABB box = boundsOf(world, shape);
    for (const std::uint32_t other :
         candidatesIn(world, shape.position + box.min, shape.position + box.max, filter)) {
        const Convex theirs = convexOf(world.shapes.geometry[other], world.shapes.corners);
        const Frame frame = relativeFrame(poseOf(world, other), shape.position, shape.rotation);
        if (distanceBetween(theirs, own, frame).distance <= 0.0f) found.push_back(idOfShape(world, other));
    }
}

void overlapBox(World& world, WorldPosition low, WorldPosition high, const QueryFilter& filter,
                std::vector<ShapeId>& found) {
    const Vec2 half = 0.5f * (high - low);
    if (std::max(half.x, half.y) > kLargest) return overlapBounds(world, low, high, filter, found);
    overlapShape(world, {.geometry = box(half), .position = low + half, .rotation = {}}, filter, found);
}

void overlapPoint(World& world, WorldPosition point, const QueryFilter& filter, std::vector<ShapeId>& found) {
    found.clear();
    if (!isUsable(point)) return;
    for (const std::uint32_t shape : candidatesIn(world, point, point, filter)) {
        const Vec2 seen = localPoint(poseOf(world, shape), point);
        if (containsPoint(world.shapes.geometry[shape], world.shapes.corners, seen))
            found.push_back(idOfShape(world, shape));
    }
}

std::optional<ClosestHit> closestPoint(World& world, WorldPosition place, float within,
                                       const QueryFilter& filter) {
    if (!isUsable(place) || !(within >= 0.0f) || !(double{within} <= kFarthest)) return std::nullopt;
    const Vec2 reach{within, within};
    std::optional<ClosestHit> best;
    for (const std::uint32_t shape : candidatesIn(world, place + -reach, place + reach, filter)) {
        const BodyPose& pose = poseOf(world, shape);
        const ClosestPoint near =
            closestPoint(world.shapes.geometry[shape], world.shapes.corners, localPoint(pose, place));
        if (near.distance > within || (best && near.distance >= best->distance)) continue;
        best = ClosestHit{idOfShape(world, shape), bodyOf(world, idOfShape(world, shape)),
                          worldPoint(pose, near.point), rotate(pose.rotation, near.normal), near.distance};
    }
    return best;
}

}  // namespace plumb::physics
