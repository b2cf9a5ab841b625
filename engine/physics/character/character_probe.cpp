#include "physics/character/character_probe.hpp"

#include <algorithm>

#include "physics/model/shapes.hpp"
#include "physics/narrowphase/collide.hpp"
#include "physics/narrowphase/distance.hpp"
#include "physics/queries/candidates.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

bool contains(const FixedList<std::uint32_t, 8>& shapes, std::uint32_t shape) {
    return std::find(shapes.begin(), shapes.end(), shape) != shapes.end();
}

/// Returns the bounds of a sweep (m), enlarged for rounding errors far from the origin.
AABB boxAlong(const AABB& bounds, WorldPosition from, Vec2 displacement, float gap) {
    const Vec2 start = toVec2(from);
    const float margin = gap + 2.0f * kRounding * (std::fabs(start.x) + std::fabs(start.y));
    const AABB box{start + bounds.min, start + bounds.max};
    return grown(merged(box, {box.min + displacement, box.max + displacement}), margin);
}

}  // namespace

bool CharacterProbe::isCarried(std::uint32_t body) const {
    const BodyMotion& motion = world_.bodies.motion[body];
    return world_.bodies.info[body].kind == BodyKind::Kinematic && dt_ > 0.0f &&
           (motion.velocity != Vec2{} || motion.angularVelocity != 0.0f);
}

BodyPose CharacterProbe::poseOf(std::uint32_t body) const {
    BodyPose pose = world_.bodies.pose[body];
    if (!isCarried(body)) return pose;
    const BodyMotion& motion = world_.bodies.motion[body];
    pose.centre = pose.centre + motion.velocity * dt_;
    if (motion.angularVelocity != 0.0f)
        pose.rotation = normalized(rotFromAngle(motion.angularVelocity * dt_) * pose.rotation);
    return pose;
}

std::span<const std::uint32_t> CharacterProbe::around(const AABB& bounds, WorldPosition from,
                                                      Vec2 displacement) const {
    if (!isUsable(from) || !isUsable(displacement)) return {};
    const float reach = kFastestSeen * dt_ + definition_.gap;
    return candidatesAlong(world_, from + bounds.center(), displacement,
                           0.5f * bounds.size() + Vec2{reach, reach}, filter);
}

bool CharacterProbe::ignores(std::uint32_t shape) const {
    const ShapeInfo& info = world_.shapes.info[shape];
    return (!oneWay && (info.flags & kOneWay) != 0) || (carrier && info.body == carrier.index) ||
           contains(behind_, shape);
}

/// True if the shape stops this hit. A one-way shape stops hits on a face or corner of its open side.
bool CharacterProbe::stops(const CastHit& hit, const BodyPose& pose, const MovingOutline& moving) const {
    const ShapeInfo& info = world_.shapes.info[hit.shape.index];
    if ((info.flags & kOneWay) == 0) return true;
    const Vec2 open = rotate(pose.rotation, world_.shapes.extras[info.extras].oneWayDirection);
    if (!(dot(hit.normal, open) > kSolidSide)) return false;
    if (hit.shape == floor) return true;
    if (hit.separation < 0.0f) return false;
    const Convex shape = convexOf(world_.shapes.geometry[hit.shape.index], world_.shapes.corners);
    const Vec2 normal = unrotate(pose.rotation, hit.normal);
    const auto corners = shape.corners();
    const bool onFace = std::any_of(corners.begin(), corners.end(), [&](const Corner& corner) {
        return dot(corner.normal, normal) > 1.0f - kParallel * kParallel;
    });
    const float feet = dot(open, moving.position - hit.point) - reachAlong(moving.outline, -open);
    return onFace || feet >= 0.0f;
}

std::optional<CastHit> CharacterProbe::cast(const Geometry& outline, WorldPosition from,
                                            Vec2 displacement) const {
    const MovingOutline moving{convexOf(outline, {}), from, {}, displacement};
    const AABB bounds = boundsOf(outline, {}, {});
    const float along = kAlong * length(displacement);
    const AABB box = boxAlong(bounds, from, displacement, definition_.gap);
    std::optional<CastHit> first;
    float closing = 0.0f;
    for (const std::uint32_t shape : around(bounds, from, displacement)) {
        const bool elsewhere = !intersects(box, world_.shapes.bounds[shape]);
        if (ignores(shape) || (elsewhere && !isCarried(world_.shapes.info[shape].body))) continue;
        const BodyPose pose = poseOf(world_.shapes.info[shape].body);
        const auto hit = meet(world_, shape, pose, moving);
        if (!hit || (first && hit->fraction >= first->fraction)) continue;
        const float nearer = -dot(displacement, hit->normal);
        if ((hit->fraction == 0.0f && !(nearer > along)) || !stops(*hit, pose, moving)) continue;
        if (hit->separation < 0.0f && contains(passed_, shape)) continue;
        first = hit;
        closing = nearer;
    }
    const float back = closing > 0.0f ? definition_.gap / closing : 0.0f;
    if (first) first->fraction = std::max(first->fraction - back, 0.0f);
    return first;
}

std::optional<CastHit> CharacterProbe::apart(std::uint32_t shape, WorldPosition at, float within) const {
    const BodyPose pose = poseOf(world_.shapes.info[shape].body);
    const Geometry& geometry = world_.shapes.geometry[shape];
    const Frame frame = relativeFrame(pose, at, Rot{});
    CastHit hit{.shape = idOfShape(world_, shape), .body = bodyOf(world_, idOfShape(world_, shape))};
    if (geometry.kind == ShapeKind::ChainSegment) {
        const Manifold manifold =
            collide(definition_.outline, geometry, world_.shapes.corners, inverse(frame), within);
        if (manifold.count == 0) return std::nullopt;
        const bool second =
            manifold.count == 2 && manifold.points[1].separation < manifold.points[0].separation;
        const ManifoldPoint& deepest = manifold.points[second ? 1 : 0];
        hit.separation = deepest.separation;
        hit.normal = -manifold.normal;
        hit.point = at + deepest.point;
        return hit;
    }
    const Distance apart =
        distanceBetween(convexOf(geometry, world_.shapes.corners), convexOf(definition_.outline, {}), frame);
    if (!(apart.distance < within)) return std::nullopt;
    hit.separation = apart.distance;
    hit.normal = rotate(pose.rotation, apart.normal);
    hit.point = worldPoint(pose, apart.pointA);
    return hit;
}

std::optional<CastHit> CharacterProbe::nearest(WorldPosition at, float within) const {
    std::optional<CastHit> best;
    for (const std::uint32_t shape : around(boundsOf(definition_.outline, {}, {}), at, {})) {
        if (ignores(shape) || contains(passed_, shape)) continue;
        if ((world_.shapes.info[shape].flags & kOneWay) != 0 && idOfShape(world_, shape) != floor) continue;
        const auto hit = apart(shape, at, within);
        if (hit && hit->separation < within && (!best || hit->separation < best->separation)) best = hit;
    }
    return best;
}

CharacterProbe::Pushes CharacterProbe::pushesAt(WorldPosition at, Vec2 ride, Vec2 own, BodyId except) {
    MovingOutline moving{convexOf(definition_.outline, {}), at, {}, {}};
    Pushes pushes;
    passed_.clear();
    behind_.clear();
    for (const std::uint32_t shape : around(boundsOf(definition_.outline, {}, {}), at, ride + own)) {
        const std::uint32_t body = world_.shapes.info[shape].body;
        if (ignores(shape) || !isCarried(body) || (except && except.index == body)) continue;
        const BodyPose& pose = world_.bodies.pose[body];
        const Vec2 taken = worldPoint(poseOf(body), localPoint(pose, at)) - at;
        moving.displacement = ride + own - taken;
        const auto hit = meet(world_, shape, pose, moving);
        const bool meets =
            hit && -dot(moving.displacement, hit->normal) > kAlong * length(moving.displacement);
        const bool stopped = meets && stops(*hit, pose, moving);
        const bool fromBehind = (world_.shapes.info[shape].flags & kOneWay) != 0 && hit && !stopped;
        if (!meets && !passed_.full()) passed_.push(shape);
        if (fromBehind && !behind_.full()) behind_.push(shape);
        if (!stopped || pushes.full()) continue;
        const float pressed = dot(taken - ride, hit->normal) * (1.0f - hit->fraction);
        if (!(pressed > 0.0f)) continue;
        pushes.push({hit->body, hit->shape, hit->normal * (pressed + definition_.gap), hit->fraction});
    }
    return pushes;
}

}  // namespace plumb::physics
