#include "scene/physics/physics_queries.hpp"

#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/model/bodies.hpp"
#include "physics/queries/overlap.hpp"
#include "physics/queries/ray_cast.hpp"
#include "physics/queries/shape_cast.hpp"
#include "physics/ranges.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/physics/collider_shapes.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics_bridge.hpp"

namespace plumb {

namespace {

constexpr float kAlong = 1e-3f;  // ratio to the displacement: a smaller approach to a shape is sliding
constexpr float kSolidSide =
    0.7f;  // minimum cosine between a hit's normal and a one-way surface's solid side

physics::QueryFilter filterFrom(const PhysicsState& state, const QueryFilter& filter) {
    physics::QueryFilter out;
    out.layers = filter.layers;
    out.mask = filter.mask;
    out.triggers = filter.triggers;
    out.movers = filter.movers;
    if (filter.except) out.except = bodyOf(state, filter.except);
    return out;
}

/// True if a hit blocks the motion. One-way surfaces block only outlines outside of them on their solid side.
bool stops(const physics::World& world, const physics::CastHit& hit, Vec2 way, bool oneWay) {
    const bool leaves = -dot(hit.normal, way) <= kAlong * length(way);
    if (leaves && way != Vec2{}) return false;
    const physics::ShapeInfo& info = world.shapes.info[hit.shape.index];
    if ((info.flags & physics::kOneWay) == 0) return true;
    const Vec2 open = rotate(rotationOf(world, hit.body), world.shapes.extras[info.extras].oneWayDirection);
    return oneWay && dot(hit.normal, open) > kSolidSide && hit.separation > -2.0f * world.settings.slop;
}

QueryHit hitFrom(const PhysicsState& state, const physics::CastHit& hit) {
    return {ownerOf(state, hit.body), hit.normal, positionInPixels(hit.point, state.scale), hit.fraction,
            hit.separation * state.scale.pixels};
}

std::optional<QueryHit> firstThatStops(const PhysicsState& state, Vec2 way, bool oneWay) {
    for (const physics::CastHit& hit : state.hits) {
        if (stops(state.world, hit, way, oneWay)) return hitFrom(state, hit);
    }
    return std::nullopt;
}

/// Limits a side of a box to the range of the physics, which knows neither a line nor what lies beyond
/// kFarthest.
void fitInRange(double& low, double& high) {
    constexpr double kMin = 2.0 * static_cast<double>(physics::kSmallest);
    if (low <= high && high - low < kMin) low -= 0.5 * kMin, high += 0.5 * kMin;
    low = std::clamp(low, -physics::kFarthest, physics::kFarthest);
    high = std::clamp(high, -physics::kFarthest, physics::kFarthest);
}

/// Calls visit(other) for each contact of an entity with another one.
template <class Visit>
void forEachTouched(const World& world, EntityId entity, const Visit& visit) {
    const PhysicsState* state = world.findResource<PhysicsState>();
    if (state == nullptr || !world.alive(entity)) return;
    const auto owner = [&](std::uint32_t body) {
        return ownerOf(*state, {body, state->world.bodies.info[body].generation});
    };
    for (const bool triggered : {false, true}) {
        physics::forTouching(state->world, triggered, [&](const physics::Contact& contact) {
            if ((contact.flags & (physics::kPassing | physics::kDisabled)) != 0) return;
            const EntityId a = owner(contact.bodyA), b = owner(contact.bodyB);
            const EntityId other = a == entity ? b : a;
            if ((a == entity || b == entity) && world.alive(other)) visit(other);
        });
    }
}

}  // namespace

std::optional<QueryHit> castBox(World& world, const AABB& box, Vec2 way, const QueryFilter& filter) {
    PhysicsState& state = world.resource<PhysicsState>();
    physics::QueryShape shape;
    shape.geometry = physics::box(toMetres(box.size() * 0.5f, state.scale));
    shape.position = positionInMetres(box.center(), state.scale);
    const Vec2 metres = toMetres(way, state.scale);
    physics::castShapeAll(state.world, shape, metres, filterFrom(state, filter), state.hits);
    return firstThatStops(state, metres, filter.oneWay);
}

std::optional<QueryHit> castRay(World& world, Vec2 from, Vec2 way, const QueryFilter& filter) {
    PhysicsState& state = world.resource<PhysicsState>();
    const Vec2 metres = toMetres(way, state.scale);
    physics::castRayAll(state.world, positionInMetres(from, state.scale), metres, filterFrom(state, filter),
                        state.hits);
    return firstThatStops(state, metres, filter.oneWay);
}

std::uint32_t collisionLayersOf(const World& world, EntityId entity) {
    const TileCollider* tiles = world.find<TileCollider>(entity);
    return shapeLayersOf(world, entity) | (tiles != nullptr ? tiles->layers : 0);
}

Vec2 tickMotionOf(World& world, EntityId entity, float dt) {
    const PhysicsState& state = world.resource<PhysicsState>();
    const physics::BodyId body = bodyOf(state, entity);
    return body ? toPixels(velocityOf(state.world, body) * dt, state.scale) : Vec2{};
}

void overlapBox(World& world, const AABB& box, const QueryFilter& filter, std::vector<EntityId>& found) {
    PhysicsState& state = world.resource<PhysicsState>();
    physics::WorldPosition low = positionInMetres(box.min, state.scale);
    physics::WorldPosition high = positionInMetres(box.max, state.scale);
    fitInRange(low.x, high.x);
    fitInRange(low.y, high.y);
    physics::overlapBox(state.world, low, high, filterFrom(state, filter), state.found);
    found.clear();
    for (const physics::ShapeId shape : state.found) {
        const EntityId entity = ownerOf(state, physics::bodyOf(state.world, shape));
        if (std::find(found.begin(), found.end(), entity) == found.end()) found.push_back(entity);
    }
}

void touchesOf(const World& world, EntityId entity, std::vector<EntityId>& found) {
    found.clear();
    forEachTouched(world, entity, [&](EntityId other) { found.push_back(other); });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

bool isTouching(const World& world, EntityId a, EntityId b) {
    bool touches = false;
    forEachTouched(world, a, [&](EntityId other) { touches = touches || other == b; });
    return touches;
}

}  // namespace plumb
