#include <algorithm>

#include "physics/model/shapes.hpp"
#include "physics/narrowphase/distance.hpp"
#include "physics/queries/candidates.hpp"
#include "physics/queries/ray_cast.hpp"
#include "physics/queries/shape_cast.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// Returns the first hit among candidate shapes; at equal distances that of the lowest index.
/// @param hitOf  returns the hit of a shape, if there is one
template <class HitOf>
std::optional<CastHit> firstHit(std::span<const std::uint32_t> shapes, HitOf&& hitOf) {
    std::optional<CastHit> first;
    for (const std::uint32_t shape : shapes) {
        const std::optional<CastHit> hit = hitOf(shape);
        if (hit && (!first || hit->fraction < first->fraction)) first = hit;
    }
    return first;
}
/// Finds all hits: nearest first; at equal distances the lowest index first.
template <class HitOf>
void allHits(std::span<const std::uint32_t> shapes, std::vector<CastHit>& hits, HitOf&& hitOf) {
    for (const std::uint32_t shape : shapes) {
        if (const std::optional<CastHit> hit = hitOf(shape)) hits.push_back(*hit);
    }
    std::sort(hits.begin(), hits.end(), [](const CastHit& a, const CastHit& b) {
        return a.fraction != b.fraction ? a.fraction < b.fraction : a.shape.index < b.shape.index;
    });
}

std::span<const std::uint32_t> candidatesOf(World& world, WorldPosition from, Vec2 displacement,
                                            const QueryFilter& filter) {
    if (!isUsable(from) || !isUsable(displacement)) return {};
    return candidatesAlong(world, from, displacement, {}, filter);
}

std::optional<CastHit> hitOf(const World& world, std::uint32_t shape, WorldPosition from, Vec2 displacement) {
    const BodyPose& pose = poseOf(world, shape);
    const std::optional<RayHit> hit =
        castRay(world.shapes.geometry[shape], world.shapes.corners,
                Ray{localPoint(pose, from), unrotate(pose.rotation, displacement)});
    if (!hit) return std::nullopt;
    return CastHit{.shape = idOfShape(world, shape),
                   .body = bodyOf(world, idOfShape(world, shape)),
                   .point = from + displacement * hit->fraction,
                   .normal = rotate(pose.rotation, hit->normal),
                   .fraction = hit->fraction,
                   .distance = hit->fraction * length(displacement)};
}

std::span<const std::uint32_t> candidatesOf(World& world, const QueryShape& shape, Vec2 displacement,
                                            const QueryFilter& filter) {
    const AABB bounds = boundsOf(world, shape);
    return candidatesAlong(world, shape.position + bounds.center(), displacement, 0.5f * bounds.size(),
                           filter);
}

MovingOutline outlineOf(const World& world, const QueryShape& shape, Vec2 displacement) {
    return {convexOf(shape.geometry, cornersOf(world, shape)), shape.position, shape.rotation, displacement};
}

/// Returns the distance (m) that counts as a hit, which includes the rounding of floats at these positions.
float touchOf(const Convex& a, const Frame& bInA) {
    const Vec2 far = bInA.position;
    const Vec2 own = a.centre;
    return kTouchDistance +
           4.0f * kRounding * (std::fabs(far.x) + std::fabs(far.y) + std::fabs(own.x) + std::fabs(own.y));
}

/// Moves B by a displacement, without rotation, until it touches A (in A's frame). An initial overlap is a
/// hit at 0; an initial touch is no hit if the displacement leads away or along the surface.
/// Source: conservative advancement, see sweep.hpp; for a straight path it converges quadratically
std::optional<CastHit> castShape(const Convex& a, const Convex& b, const Frame& bInA, Vec2 displacement) {
    SimplexCache cache;
    CastHit hit;
    for (int iteration = 0; iteration < kMaxRounds; ++iteration) {
        const Frame frame{bInA.position + displacement * hit.fraction, bInA.rotation};
        const Distance apart = distanceBetween(a, b, frame, &cache);
        hit.normal = apart.normal;
        hit.point = apart.pointA;
        if (iteration == 0) hit.separation = apart.distance;
        const float speed = -dot(displacement, apart.normal);
        const float touch = touchOf(a, frame);
        if (!(apart.distance > touch)) {
            const bool slides = apart.distance >= -touch && speed <= kAlong * length(displacement);
            return slides ? std::nullopt : std::optional{hit};
        }
        if (!(speed > 0.0f)) return std::nullopt;
        const float next = hit.fraction + apart.distance / speed;
        if (!(next <= 1.0f)) return std::nullopt;
        if (next == hit.fraction) return hit;
        hit.fraction = next;
    }
    return std::nullopt;  // too many iterations: a narrow miss
}

}  // namespace

std::optional<CastHit> castRay(World& world, WorldPosition from, Vec2 displacement,
                               const QueryFilter& filter) {
    return firstHit(candidatesOf(world, from, displacement, filter),
                    [&](std::uint32_t shape) { return hitOf(world, shape, from, displacement); });
}

bool isRayBlocked(World& world, WorldPosition from, Vec2 displacement, const QueryFilter& filter) {
    const std::span<const std::uint32_t> candidates = candidatesOf(world, from, displacement, filter);
    return std::any_of(candidates.begin(), candidates.end(), [&](std::uint32_t shape) {
        return hitOf(world, shape, from, displacement).has_value();
    });
}

void castRayAll(World& world, WorldPosition from, Vec2 displacement, const QueryFilter& filter,
                std::vector<CastHit>& hits) {
    hits.clear();
    allHits(candidatesOf(world, from, displacement, filter), hits,
            [&](std::uint32_t shape) { return hitOf(world, shape, from, displacement); });
}

std::optional<CastHit> meet(const World& world, std::uint32_t shape, const BodyPose& pose,
                            const MovingOutline& moving) {
    const Geometry& geometry = world.shapes.geometry[shape];
    const bool isChain = geometry.kind == ShapeKind::ChainSegment;
    const Frame frame = relativeFrame(pose, moving.position, moving.rotation);
    const Vec2 displacement = unrotate(pose.rotation, moving.displacement);
    const Vec2 front = isChain ? normalOfChain(geometry) : Vec2{};
    if (isChain) {
        const float height = dot(front, apply(frame, moving.outline.centre) - geometry.a);
        if (height < 0.0f || dot(front, displacement) >= 0.0f) return std::nullopt;
    }
    const Convex theirs = convexOf(geometry, world.shapes.corners);
    std::optional<CastHit> hit = castShape(theirs, moving.outline, frame, displacement);
    if (!hit) return std::nullopt;
    hit->shape = idOfShape(world, shape);
    hit->body = bodyOf(world, hit->shape);
    hit->point = worldPoint(pose, toVec2(hit->point));
    // At an overlap with a chain segment the computed normal may point to its back.
    hit->normal = rotate(pose.rotation, isChain && hit->separation < 0.0f ? front : hit->normal);
    hit->distance = hit->fraction * length(moving.displacement);
    return hit;
}

std::optional<CastHit> castShape(World& world, const QueryShape& shape, Vec2 displacement,
                                 const QueryFilter& filter) {
    if (!isUsable(world, shape) || !isUsable(displacement)) return std::nullopt;
    const MovingOutline moving = outlineOf(world, shape, displacement);
    return firstHit(candidatesOf(world, shape, displacement, filter),
                    [&](std::uint32_t other) { return meet(world, other, poseOf(world, other), moving); });
}

void castShapeAll(World& world, const QueryShape& shape, Vec2 displacement, const QueryFilter& filter,
                  std::vector<CastHit>& hits) {
    hits.clear();
    if (!isUsable(world, shape) || !isUsable(displacement)) return;
    const MovingOutline moving = outlineOf(world, shape, displacement);
    allHits(candidatesOf(world, shape, displacement, filter), hits,
            [&](std::uint32_t other) { return meet(world, other, poseOf(world, other), moving); });
}

}  // namespace plumb::physics
