#include "scene/physics_queries.hpp"

#include "box_physics/queries/cast.hpp"
#include "scene/body_sync.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/physics_state.hpp"
#include "scene/physics_units.hpp"

namespace plumb {

namespace {

box_physics::Filter filterFrom(World& world, const QueryFilter& filter) {
    box_physics::Filter out;
    out.layers = filter.layers;
    out.mask = filter.mask;
    out.except = filter.except ? bodyOf(world, filter.except) : box_physics::BodyId{};
    out.triggers = filter.triggers;
    out.oneWay = filter.oneWay;
    out.movers = filter.movers;
    return out;
}

std::optional<QueryHit> hitFrom(const PhysicsState& state, const std::optional<box_physics::CastHit>& hit) {
    if (!hit) return std::nullopt;
    return QueryHit{state.links[hit->body.index].entity, hit->touch.normal, toPixels(hit->point),
                    hit->touch.time, hit->touch.separation * kPixelsPerMetre};
}

box_physics::Mover moverFrom(const AABB& box, Vec2 way) {
    return {box_physics::ShapeKind::Box, toMetres(box.center()), toMetres(box.size() * 0.5f), toMetres(way),
            0.0f};
}

}  // namespace

std::optional<QueryHit> castBox(World& world, const AABB& box, Vec2 way, const QueryFilter& filter) {
    PhysicsState& state = world.resource<PhysicsState>();
    return hitFrom(state, box_physics::shapeCast(state.world, moverFrom(box, way), physicsSettingsOf(world),
                                             filterFrom(world, filter)));
}

std::optional<QueryHit> castRay(World& world, Vec2 from, Vec2 way, const QueryFilter& filter) {
    PhysicsState& state = world.resource<PhysicsState>();
    return hitFrom(state, box_physics::rayCast(state.world, toMetres(from), toMetres(way),
                                           physicsSettingsOf(world), filterFrom(world, filter)));
}

Vec2 tickMotionOf(World& world, EntityId entity, float dt) {
    const box_physics::BodyId body = bodyOf(world, entity);
    if (!body) return {};
    const box_physics::Bodies& bodies = world.resource<PhysicsState>().world.bodies;
    if ((bodies.flags[body.index] & box_physics::kHasTarget) != 0) {
        return toPixels(bodies.target[body.index] - bodies.position[body.index]);
    }
    const bool moves = bodies.kind[body.index] != box_physics::BodyKind::Static;
    return moves ? toPixels(bodies.velocity[body.index] * dt) : Vec2{};
}

void overlapBox(World& world, const AABB& box, const QueryFilter& filter, std::vector<EntityId>& found) {
    PhysicsState& state = world.resource<PhysicsState>();
    std::vector<box_physics::BodyId> bodies;
    box_physics::overlap(state.world, moverFrom(box, {}), physicsSettingsOf(world), filterFrom(world, filter),
                     bodies);
    found.clear();
    for (const box_physics::BodyId body : bodies) found.push_back(state.links[body.index].entity);
}

}  // namespace plumb
